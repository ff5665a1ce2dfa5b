// The key names and functions that #iKeyboard gives to a shader.
#pragma once

#include <string>

namespace shadertwin {

// GLSL: one `const int Key_NAME` for each key, isKeyDown, isKeyPressed, isKeyToggled and isKeyReleased.
std::string keyboard_text();

}  // namespace shadertwin
