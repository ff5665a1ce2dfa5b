// Which keys belong to the window. All others belong to the shader.
#pragma once

#include <optional>
#include <span>

namespace shadertwin::view {

enum class Action {
  help,
  hud,
  inspector,
  uniforms,
  reset,
  pause,
  mute,
  step,
  previous_pass,
  next_pass,
  scale,
  full_screen,
  screenshot,
  record,
  paint,
  quit,
};

struct Binding {
  Action action;
  int key;        // GLFW's
  int modifiers;  // GLFW's; none of the others may be down
  const char* name;
  const char* help;
};

std::span<const Binding> bindings();

// What the window does for a key. Nothing for a key of the shader's.
std::optional<Action> action_for(int key, int modifiers);

// The browser's legacy keyCode for GLFW's key. Nothing where browsers have none.
std::optional<int> browser_code(int key);

}  // namespace shadertwin::view
