// The characters that GLSL's words and numbers are made of, whatever the locale.
#pragma once

namespace shadertwin {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Letters and `_`.
inline bool starts_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

inline bool in_word(char c) {
  return starts_word(c) || is_digit(c);
}

}  // namespace shadertwin
