// Two numbers in 32 bits, for any type that converts to float. Packets go lane by lane.
#pragma once

#include "reference/glsl/common.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// IEEE half precision, rounded to nearest even; a NaN has all bits set.
constexpr uint half_of(float value) {
  const uint pattern = std::bit_cast<uint>(value);
  const uint sign = (pattern >> 16) & 0x8000U;
  const uint magnitude = pattern & 0x7fffffffU;
  if (magnitude > 0x7f800000U) return sign | 0x7fffU;
  if (magnitude >= 0x477ff000U) return sign | 0x7c00U;  // 65520 and above round to infinity
  if (magnitude < 0x33000000U) return sign;             // below half of the smallest
  const uint exponent = magnitude >> 23;
  const bool normal = exponent >= 113;
  const uint shift = normal ? 13 : 126 - exponent;
  const uint mantissa = normal ? magnitude - 0x38000000U : (magnitude & 0x7fffffU) | 0x800000U;
  const uint halfway = 1U << (shift - 1);
  const uint kept = mantissa >> shift;
  const uint dropped = mantissa & ((1U << shift) - 1U);
  return sign | (kept + (dropped > halfway || (dropped == halfway && (kept & 1U) != 0) ? 1U : 0U));
}

constexpr float float_of(uint half) {
  const uint sign = (half & 0x8000U) << 16;
  const uint exponent = (half >> 10) & 31U;
  const uint mantissa = half & 0x3ffU;
  if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000U | (mantissa << 13));
  if (exponent > 0) return std::bit_cast<float>(sign | ((exponent + 112U) << 23) | (mantissa << 13));
  const float magnitude = static_cast<float>(mantissa) * 0x1p-24F;
  return std::bit_cast<float>(sign | std::bit_cast<uint>(magnitude));
}

template <class Uint, class F>
Uint packHalf2x16_of(const glm::vec<2, F>& v) {
  return half_of(static_cast<float>(v.x)) | (half_of(static_cast<float>(v.y)) << 16);
}
template <class Vector>
Vector unpackHalf2x16_of(uint p) {
  return Vector(float_of(p & 0xffffU), float_of(p >> 16));
}

// The steps of size 1 / scale that x is in [low, 1].
template <class F>
SHADERTWIN_INLINE float steps(F x, float low, float scale) {
  return static_cast<float>(
      round_to_even(min_of(max_of(x, constant<F>(low)), constant<F>(1)) * constant<F>(scale)));
}
template <class Uint, class F>
Uint packUnorm2x16_of(const glm::vec<2, F>& v) {
  return static_cast<uint>(steps(v.x, 0.0F, 65535.0F)) |
         (static_cast<uint>(steps(v.y, 0.0F, 65535.0F)) << 16);
}
template <class Vector>
Vector unpackUnorm2x16_of(uint p) {
  using F = typename Vector::value_type;
  return Vector(constant<F>(p & 0xffffU) / constant<F>(65535), constant<F>(p >> 16) / constant<F>(65535));
}
template <class Uint, class F>
Uint packSnorm2x16_of(const glm::vec<2, F>& v) {
  return (static_cast<uint>(static_cast<int>(steps(v.x, -1.0F, 32767.0F))) & 0xffffU) |
         (static_cast<uint>(static_cast<int>(steps(v.y, -1.0F, 32767.0F))) << 16);
}
template <class Vector>
Vector unpackSnorm2x16_of(uint p) {
  using F = typename Vector::value_type;
  const auto number = [](uint half) {
    const F x = constant<F>(static_cast<std::int16_t>(half)) / constant<F>(32767);
    return min_of(max_of(x, constant<F>(-1)), constant<F>(1));
  };
  return Vector(number(p & 0xffffU), number(p >> 16));
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
