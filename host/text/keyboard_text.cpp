#include "host/text/keyboard_text.h"

#include <utility>

namespace shadertwin {

namespace {

// The extension's own names, with its two spellings of "RightWindows" and "CloseBraket".
constexpr std::pair<const char*, int> named_keys[] = {
    {"Backspace", 8},
    {"Tab", 9},
    {"Enter", 13},
    {"Shift", 16},
    {"Ctrl", 17},
    {"Alt", 18},
    {"Pause", 19},
    {"Caps", 20},
    {"Escape", 27},
    {"PageUp", 33},
    {"PageDown", 34},
    {"End", 35},
    {"Home", 36},
    {"LeftArrow", 37},
    {"UpArrow", 38},
    {"RightArrow", 39},
    {"DownArrow", 40},
    {"Insert", 45},
    {"Delete", 46},
    {"LeftWindow", 91},
    {"RightWindows", 92},
    {"Select", 93},
    {"NumpadMultiply", 106},
    {"NumpadAdd", 107},
    {"NumpadSubtract", 109},
    {"NumpadPeriod", 110},
    {"NumpadDivide", 111},
    {"NumLock", 144},
    {"ScrollLock", 145},
    {"SemiColon", 186},
    {"Equal", 187},
    {"Comma", 188},
    {"Dash", 189},
    {"Period", 190},
    {"ForwardSlash", 191},
    {"GraveAccent", 192},
    {"OpenBracket", 219},
    {"BackSlash", 220},
    {"CloseBraket", 221},
    {"SingleQuote", 222},
};

std::string key(const std::string& name, int code) {
  return "const int Key_" + name + " = " + std::to_string(code) + ";\n";
}

std::string row_function(const std::string& name, const char* row) {
  return "bool " + name + "(int key) { return texture(iKeyboard, vec2(float(key) / 255.0, " + row +
         ")).x > 0.0; }\n";
}

}  // namespace

std::string keyboard_text() {
  std::string text;
  for (const auto& [name, code] : named_keys) text += key(name, code);
  for (int i = 0; i < 10; ++i)
    text += key(std::to_string(i), 48 + i) + key("Numpad" + std::to_string(i), 96 + i);
  for (int i = 0; i < 26; ++i) text += key(std::string(1, static_cast<char>('A' + i)), 65 + i);
  for (int i = 1; i <= 12; ++i) text += key("F" + std::to_string(i), 111 + i);
  return text + row_function("isKeyDown", "0.125") + row_function("isKeyPressed", "0.375") +
         row_function("isKeyToggled", "0.625") + row_function("isKeyReleased", "0.875");
}

}  // namespace shadertwin
