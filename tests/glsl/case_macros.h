// One text, read by the C++ compiler and by the device's GLSL compiler.
#pragma once

#include "tests/glsl/builtin_cases.h"

#define XY(v) (v).xy()
#define ZW(v) (v).zw()
#define XYZ(v) (v).xyz()
#define MAKE(type, v) make<type>(v)
#define DIVIDE(x, y) divide(x, y)
#define MODULO(x, y) modulo(x, y)
#define SHIFT_LEFT(x, y) shift_left(x, y)
#define SHIFT_RIGHT(x, y) shift_right(x, y)

#define SHADERTWIN_BODY(...) \
#__VA_ARGS__ ";", [](const Arguments& arguments) {                                           \
    [[maybe_unused]] auto [a, b, c, d, e, f, g, h] = arguments;                                \
    vec4 r(0);                                                                                 \
    __VA_ARGS__;                                                                               \
    return r;                                                                                  \
  }

namespace shadertwin::glsl {

// Two integers as four floats that hold them exactly.
inline vec4 halves(uint a, uint b) {
  return vec4(static_cast<Float>(a >> 16), static_cast<Float>(a & 0xffffU), static_cast<Float>(b >> 16),
              static_cast<Float>(b & 0xffffU));
}

inline constexpr Domain anything{Domain::Kind::bits, 0, 0};
inline constexpr Domain unit{Domain::Kind::unit, 0, 0};
constexpr Domain range(int high) {
  return {Domain::Kind::range, 0, high};
}
constexpr Domain scale(int low, int high) {
  return {Domain::Kind::scale, low, high};
}
constexpr Domain positive(int low, int high) {
  return {Domain::Kind::positive, low, high};
}

}  // namespace shadertwin::glsl
