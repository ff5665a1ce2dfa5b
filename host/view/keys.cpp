#include "host/view/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace shadertwin::view {

namespace {

constexpr std::array<Binding, 16> table = {{
    {Action::help, GLFW_KEY_F1, 0, "F1", "this list"},
    {Action::hud, GLFW_KEY_F2, 0, "F2", "frame rate, times, resolution, device"},
    {Action::inspector, GLFW_KEY_F3, 0, "F3",
     "pixel inspector: values under the mouse; a click prints commands"},
    {Action::paint, GLFW_KEY_F3, GLFW_MOD_SHIFT, "Shift+F3", "paint NaN magenta, infinities yellow and cyan"},
    {Action::uniforms, GLFW_KEY_F4, 0, "F4", "sliders of the shader's #iUniforms"},
    {Action::reset, GLFW_KEY_F5, 0, "F5", "back to time zero"},
    {Action::pause, GLFW_KEY_F6, 0, "F6", "pause, go on"},
    {Action::mute, GLFW_KEY_F6, GLFW_MOD_SHIFT, "Shift+F6", "sound off, on"},
    {Action::step, GLFW_KEY_F7, 0, "F7", "pause and draw one more frame"},
    {Action::previous_pass, GLFW_KEY_F8, 0, "F8", "show the previous pass"},
    {Action::next_pass, GLFW_KEY_F9, 0, "F9", "show the next pass"},
    {Action::scale, GLFW_KEY_F10, 0, "F10", "resolution 1, 1/2, 1/4, 2"},
    {Action::full_screen, GLFW_KEY_F11, 0, "F11", "full screen"},
    {Action::screenshot, GLFW_KEY_F12, 0, "F12", "screenshot: PNG, and EXR with every bit"},
    {Action::record, GLFW_KEY_F12, GLFW_MOD_SHIFT, "Shift+F12", "start or stop recording"},
    {Action::quit, GLFW_KEY_Q, GLFW_MOD_CONTROL, "Ctrl+Q", "quit"},
}};

// Keys outside of the ranges where both count alike.
constexpr std::array<std::pair<int, int>, 46> codes = {{
    {GLFW_KEY_BACKSPACE, 8},
    {GLFW_KEY_TAB, 9},
    {GLFW_KEY_ENTER, 13},
    {GLFW_KEY_KP_ENTER, 13},
    {GLFW_KEY_LEFT_SHIFT, 16},
    {GLFW_KEY_RIGHT_SHIFT, 16},
    {GLFW_KEY_LEFT_CONTROL, 17},
    {GLFW_KEY_RIGHT_CONTROL, 17},
    {GLFW_KEY_LEFT_ALT, 18},
    {GLFW_KEY_RIGHT_ALT, 18},
    {GLFW_KEY_PAUSE, 19},
    {GLFW_KEY_CAPS_LOCK, 20},
    {GLFW_KEY_ESCAPE, 27},
    {GLFW_KEY_SPACE, 32},
    {GLFW_KEY_PAGE_UP, 33},
    {GLFW_KEY_PAGE_DOWN, 34},
    {GLFW_KEY_END, 35},
    {GLFW_KEY_HOME, 36},
    {GLFW_KEY_LEFT, 37},
    {GLFW_KEY_UP, 38},
    {GLFW_KEY_RIGHT, 39},
    {GLFW_KEY_DOWN, 40},
    {GLFW_KEY_PRINT_SCREEN, 44},
    {GLFW_KEY_INSERT, 45},
    {GLFW_KEY_DELETE, 46},
    {GLFW_KEY_LEFT_SUPER, 91},
    {GLFW_KEY_RIGHT_SUPER, 92},
    {GLFW_KEY_MENU, 93},
    {GLFW_KEY_KP_MULTIPLY, 106},
    {GLFW_KEY_KP_ADD, 107},
    {GLFW_KEY_KP_SUBTRACT, 109},
    {GLFW_KEY_KP_DECIMAL, 110},
    {GLFW_KEY_KP_DIVIDE, 111},
    {GLFW_KEY_NUM_LOCK, 144},
    {GLFW_KEY_SCROLL_LOCK, 145},
    {GLFW_KEY_SEMICOLON, 186},
    {GLFW_KEY_EQUAL, 187},
    {GLFW_KEY_COMMA, 188},
    {GLFW_KEY_MINUS, 189},
    {GLFW_KEY_PERIOD, 190},
    {GLFW_KEY_SLASH, 191},
    {GLFW_KEY_GRAVE_ACCENT, 192},
    {GLFW_KEY_LEFT_BRACKET, 219},
    {GLFW_KEY_BACKSLASH, 220},
    {GLFW_KEY_RIGHT_BRACKET, 221},
    {GLFW_KEY_APOSTROPHE, 222},
}};

}  // namespace

std::span<const Binding> bindings() {
  return table;
}

std::optional<Action> action_for(int key, int modifiers) {
  constexpr int counted = GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  for (const Binding& binding : table)
    if (binding.key == key && binding.modifiers == (modifiers & counted)) return binding.action;
  return std::nullopt;
}

std::optional<int> browser_code(int key) {
  if ((key >= GLFW_KEY_0 && key <= GLFW_KEY_9) || (key >= GLFW_KEY_A && key <= GLFW_KEY_Z)) return key;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return 112 + key - GLFW_KEY_F1;
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return 96 + key - GLFW_KEY_KP_0;
  const auto* found =
      std::find_if(codes.begin(), codes.end(), [key](const auto& c) { return c.first == key; });
  return found == codes.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace shadertwin::view
