// GLSL's common functions: rounding, comparison, blending, classification, and the bits of floats.
#pragma once

#include "reference/glsl/exponential.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

// --- Magnitude and rounding -------------------------------------------------

SHADERTWIN_INLINE Float abs(Float x) {
  return std::fabs(x);
}
SHADERTWIN_INLINE int abs(int x) {
  return x < 0 ? static_cast<int>(0U - static_cast<uint>(x)) : x;
}
// 0 for a NaN, as llvmpipe has it.
SHADERTWIN_INLINE Float sign(Float x) {
  return x > 0 ? Float(1) : x < 0 ? Float(-1) : Float(0);
}
SHADERTWIN_INLINE int sign(int x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}
SHADERTWIN_INLINE Float floor(Float x) {
  return std::floor(x);
}
SHADERTWIN_INLINE Float ceil(Float x) {
  return std::ceil(x);
}
SHADERTWIN_INLINE Float trunc(Float x) {
  return std::trunc(x);
}
SHADERTWIN_INLINE Float roundEven(Float x) {
  return std::rint(x);
}
SHADERTWIN_INLINE Float round(Float x) {
  return std::rint(x);
}  // Mesa rounds halves to even here too
SHADERTWIN_INLINE Float fract(Float x) {
  return x - std::floor(x);
}
SHADERTWIN_INLINE Float mod(Float x, Float y) {
  SHADERTWIN_PROBE(y == 0, mod_by_zero);
  return x - y * std::floor(x / y);
}
SHADERTWIN_INLINE Float modf(Float x, Float& whole) {
  whole = std::trunc(x);
  return x - whole;
}
SHADERTWIN_MAP_1(abs, vec, vec)
SHADERTWIN_MAP_1(abs, ivec, ivec)
SHADERTWIN_MAP_1(sign, vec, vec)
SHADERTWIN_MAP_1(sign, ivec, ivec)
SHADERTWIN_MAP_1(floor, vec, vec)
SHADERTWIN_MAP_1(ceil, vec, vec)
SHADERTWIN_MAP_1(trunc, vec, vec)
SHADERTWIN_MAP_1(roundEven, vec, vec)
SHADERTWIN_MAP_1(round, vec, vec)
SHADERTWIN_MAP_1(fract, vec, vec)
SHADERTWIN_MAP_2(mod, vec, vec, vec)
SHADERTWIN_MAP_2_SCALAR(mod, vec, vec, Float)
SHADERTWIN_INLINE vec2 modf(vec2 x, vec2& whole) {
  whole = trunc(x);
  return x - whole;
}
SHADERTWIN_INLINE vec3 modf(vec3 x, vec3& whole) {
  whole = trunc(x);
  return x - whole;
}
SHADERTWIN_INLINE vec4 modf(vec4 x, vec4& whole) {
  whole = trunc(x);
  return x - whole;
}

// --- Smaller and larger -----------------------------------------------------

// The other operand if one is a NaN; of two zeros the second.
SHADERTWIN_INLINE Float min(Float a, Float b) {
  if (b != b) [[unlikely]]
    return a;
  return detail::first_if_less(a, b);
}
SHADERTWIN_INLINE Float max(Float a, Float b) {
  if (b != b) [[unlikely]]
    return a;
  return detail::first_if_greater(a, b);
}
SHADERTWIN_INLINE int min(int a, int b) {
  return a < b ? a : b;
}
SHADERTWIN_INLINE int max(int a, int b) {
  return a > b ? a : b;
}
SHADERTWIN_INLINE uint min(uint a, uint b) {
  return a < b ? a : b;
}
SHADERTWIN_INLINE uint max(uint a, uint b) {
  return a > b ? a : b;
}
SHADERTWIN_INLINE Float clamp(Float x, Float low, Float high) {
  SHADERTWIN_PROBE(low > high, clamp_crossed);
  return min(max(x, low), high);
}
SHADERTWIN_INLINE int clamp(int x, int low, int high) {
  SHADERTWIN_PROBE(low > high, clamp_crossed);
  return min(max(x, low), high);
}
SHADERTWIN_INLINE uint clamp(uint x, uint low, uint high) {
  SHADERTWIN_PROBE(low > high, clamp_crossed);
  return min(max(x, low), high);
}

#define SHADERTWIN_ORDER(family, scalar)                                                   \
  SHADERTWIN_MAP_2(min, family, family, family)                                            \
  SHADERTWIN_MAP_2_SCALAR(min, family, family, scalar)                                     \
  SHADERTWIN_MAP_2(max, family, family, family)                                            \
  SHADERTWIN_MAP_2_SCALAR(max, family, family, scalar)                                     \
  SHADERTWIN_MAP_3(clamp, family, family, family, family)                                  \
  SHADERTWIN_INLINE family##2 clamp(family##2 x, scalar low, scalar high) {                \
    return family##2(clamp(x.x, low, high), clamp(x.y, low, high));                        \
  }                                                                                        \
  SHADERTWIN_INLINE family##3 clamp(family##3 x, scalar low, scalar high) {                \
    return family##3(clamp(x.x, low, high), clamp(x.y, low, high), clamp(x.z, low, high)); \
  }                                                                                        \
  SHADERTWIN_INLINE family##4 clamp(family##4 x, scalar low, scalar high) {                \
    return family##4(clamp(x.x, low, high), clamp(x.y, low, high), clamp(x.z, low, high),  \
                     clamp(x.w, low, high));                                               \
  }
SHADERTWIN_ORDER(vec, Float)
SHADERTWIN_ORDER(ivec, int)
SHADERTWIN_ORDER(uvec, uint)
#undef SHADERTWIN_ORDER

// --- Blending ---------------------------------------------------------------

SHADERTWIN_INLINE Float mix(Float a, Float b, Float t) {
  return a + t * (b - a);
}
// What Mesa makes of mix() that is `precise`, or whose t is a constant, or whose b is the constant 1 or -1.
SHADERTWIN_INLINE Float mix_strict(Float a, Float b, Float t) {
  return a * (Float(1) - t) + b * t;
}
SHADERTWIN_INLINE Float mix(Float a, Float b, bool second) {
  return second ? b : a;
}
SHADERTWIN_INLINE Float step(Float edge, Float x) {
  return x >= edge ? Float(1) : Float(0);
}
SHADERTWIN_INLINE Float smoothstep(Float edge0, Float edge1, Float x) {
  SHADERTWIN_PROBE(edge0 >= edge1, smoothstep_crossed);
  const Float t = min(max((x - edge0) / (edge1 - edge0), Float(0)), Float(1));
  return t * (t * (Float(3) - Float(2) * t));
}
SHADERTWIN_MAP_3(mix, vec, vec, vec, vec)
SHADERTWIN_MAP_3(mix, vec, vec, vec, bvec)
SHADERTWIN_MAP_3(mix_strict, vec, vec, vec, vec)
SHADERTWIN_MAP_2(step, vec, vec, vec)
SHADERTWIN_MAP_SCALAR_2(step, vec, Float, vec)
SHADERTWIN_MAP_3(smoothstep, vec, vec, vec, vec)

#define SHADERTWIN_BLEND(N)                                                 \
  SHADERTWIN_INLINE vec##N mix(vec##N a, vec##N b, Float t) {               \
    return mix(a, b, vec##N(t));                                            \
  }                                                                         \
  SHADERTWIN_INLINE vec##N mix_strict(vec##N a, vec##N b, Float t) {        \
    return mix_strict(a, b, vec##N(t));                                     \
  }                                                                         \
  SHADERTWIN_INLINE vec##N smoothstep(Float edge0, Float edge1, vec##N x) { \
    return smoothstep(vec##N(edge0), vec##N(edge1), x);                     \
  }
SHADERTWIN_BLEND(2)
SHADERTWIN_BLEND(3)
SHADERTWIN_BLEND(4)
#undef SHADERTWIN_BLEND

// --- Classification and bits ------------------------------------------------

SHADERTWIN_INLINE bool isnan(Float x) {
  return x != x;
}
SHADERTWIN_INLINE bool isinf(Float x) {
  return std::fabs(x) == detail::infinity;
}
// Widened to double, a value passes through float here: there are only 32 bits.
SHADERTWIN_INLINE int floatBitsToInt(Float x) {
  return std::bit_cast<int>(static_cast<float>(x));
}
SHADERTWIN_INLINE uint floatBitsToUint(Float x) {
  return std::bit_cast<uint>(static_cast<float>(x));
}
SHADERTWIN_INLINE Float intBitsToFloat(int x) {
  return std::bit_cast<float>(x);
}
SHADERTWIN_INLINE Float uintBitsToFloat(uint x) {
  return std::bit_cast<float>(x);
}
SHADERTWIN_MAP_1(isnan, bvec, vec)
SHADERTWIN_MAP_1(isinf, bvec, vec)
SHADERTWIN_MAP_1(floatBitsToInt, ivec, vec)
SHADERTWIN_MAP_1(floatBitsToUint, uvec, vec)
SHADERTWIN_MAP_1(intBitsToFloat, vec, ivec)
SHADERTWIN_MAP_1(uintBitsToFloat, vec, uvec)

namespace detail {

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

}  // namespace detail

inline uint packHalf2x16(vec2 v) {
  return detail::half_of(static_cast<float>(v.x)) | (detail::half_of(static_cast<float>(v.y)) << 16);
}
inline vec2 unpackHalf2x16(uint p) {
  return vec2(detail::float_of(p & 0xffffU), detail::float_of(p >> 16));
}
inline uint packUnorm2x16(vec2 v) {
  const vec2 scaled = roundEven(min(max(v, Float(0)), Float(1)) * Float(65535));
  return static_cast<uint>(scaled.x) | (static_cast<uint>(scaled.y) << 16);
}
inline vec2 unpackUnorm2x16(uint p) {
  return vec2(static_cast<Float>(p & 0xffffU), static_cast<Float>(p >> 16)) / Float(65535);
}
inline uint packSnorm2x16(vec2 v) {
  const vec2 scaled = roundEven(min(max(v, Float(-1)), Float(1)) * Float(32767));
  return (static_cast<uint>(static_cast<int>(scaled.x)) & 0xffffU) |
         (static_cast<uint>(static_cast<int>(scaled.y)) << 16);
}
inline vec2 unpackSnorm2x16(uint p) {
  const vec2 scaled(static_cast<Float>(static_cast<std::int16_t>(p & 0xffffU)),
                    static_cast<Float>(static_cast<std::int16_t>(p >> 16)));
  return min(max(scaled / Float(32767), Float(-1)), Float(1));
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
