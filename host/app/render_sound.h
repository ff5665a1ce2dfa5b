// `render` into a file of sound.
#pragma once

#include <string>

#include "host/app/options.h"

namespace shadertwin::app {

// Plays the Sound pass for `seconds` from --time on into a .wav or .flac. Throws Error(usage) if the shader
// has none.
void render_sound(const PlayOptions& options, double seconds, const std::string& output);

}  // namespace shadertwin::app
