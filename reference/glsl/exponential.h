// Roots, exponentials and logarithms.
//
// As float they compute what Mesa 22.3's llvmpipe computes, operation by operation (the polynomials of
// gallivm's lp_bld_arit.c, fused where the processor can, as there), so that both have the same bits. As
// double they are libm's, with GLSL's domains.
#pragma once

#include <bit>
#include <cmath>
#include <limits>

#include "reference/glsl/componentwise.h"

namespace shadertwin::glsl {

namespace detail {

constexpr Float infinity = std::numeric_limits<Float>::infinity();
constexpr Float nan = std::numeric_limits<Float>::quiet_NaN();
constexpr Float half_pi = Float(1.57079632679489661923);

SHADERTWIN_INLINE uint bits(float x) {
  return std::bit_cast<uint>(x);
}
SHADERTWIN_INLINE float from_bits(uint x) {
  return std::bit_cast<float>(x);
}

// x86's minps and maxps: the second operand if the two are equal or one is a NaN.
#if defined(__SSE2__) && !defined(SHADERTWIN_DOUBLE)
SHADERTWIN_INLINE float first_if_less(float a, float b) {
  return _mm_cvtss_f32(_mm_min_ss(lane(a), lane(b)));
}
SHADERTWIN_INLINE float first_if_greater(float a, float b) {
  return _mm_cvtss_f32(_mm_max_ss(lane(a), lane(b)));
}
#else
SHADERTWIN_INLINE Float first_if_less(Float a, Float b) {
  return a < b ? a : b;
}
SHADERTWIN_INLINE Float first_if_greater(Float a, Float b) {
  return a > b ? a : b;
}
#endif

#ifndef SHADERTWIN_DOUBLE

// LLVM's fmuladd.
SHADERTWIN_INLINE float multiply_add(float a, float b, float c) {
#ifdef __FMA__
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}

SHADERTWIN_INLINE int truncate(float x) {
#if defined(__SSE2__)
  return _mm_cvttss_si32(lane(x));
#else
  return x != x ? 0 : x <= -2147483648.0F ? INT32_MIN : x >= 2147483648.0F ? INT32_MAX : static_cast<int>(x);
#endif
}

#endif

}  // namespace detail

// --- Roots
// --------------------------------------------------------------------------------------------------

SHADERTWIN_INLINE Float sqrt(Float x) {
  SHADERTWIN_PROBE(x < 0, sqrt_negative);
  return std::sqrt(x);
}
SHADERTWIN_INLINE Float inversesqrt(Float x) {
  SHADERTWIN_PROBE(x <= 0, inversesqrt_not_positive);
  return Float(1) / std::sqrt(x);
}
SHADERTWIN_MAP_1(sqrt, vec, vec)
SHADERTWIN_MAP_1(inversesqrt, vec, vec)

// --- Exponentials
// -------------------------------------------------------------------------------------------

#ifdef SHADERTWIN_DOUBLE

namespace detail {
SHADERTWIN_INLINE double exp2_of(double x) {
  return std::exp2(x);
}
SHADERTWIN_INLINE double log2_of(double x) {
  return std::log2(x);
}
SHADERTWIN_INLINE double exp_of(double x) {
  return std::exp(x);
}
SHADERTWIN_INLINE double log_of(double x) {
  return std::log(x);
}
SHADERTWIN_INLINE double pow_of(double x, double y) {
  return x == 0 ? 0 : x > 0 ? std::pow(x, y) : nan;
}
}  // namespace detail

#else

namespace detail {

// 2^floor(x) from the exponent's bits times a polynomial of degree 5 for the rest. Below 2^-126 it is 0.
inline float exp2_of(float x) {
  x = first_if_less(128.0F, x);
  x = first_if_greater(-126.99999F, x);
  const float whole = std::floor(x);
  const float f = x - whole;
  const float scale = from_bits((static_cast<uint>(truncate(whole)) + 127U) << 23);
  const float f2 = f * f;
  const float even =
      multiply_add(f2, multiply_add(f2, 0.00898934009049466391101F, 0.240153617044375388211F), 1.0F);
  const float odd = multiply_add(f2, multiply_add(f2, 0.00187757667519147912699F, 0.0558263180532956664775F),
                                 0.693153073200168932794F);
  return scale * multiply_add(odd, f, even);
}

// The exponent plus log2 of the mantissa m in [1, 2), as a polynomial of ((m - 1) / (m + 1))^2.
inline float log2_of(float x) {
  const uint pattern = bits(x);
  const float exponent = static_cast<float>(static_cast<int>((pattern & 0x7f800000U) >> 23) - 127);
  const float m = from_bits((pattern & 0x007fffffU) | 0x3f800000U);
  const float y = (m - 1.0F) / (m + 1.0F);
  const float z = y * y;
  const float z2 = z * z;
  const float even = multiply_add(z2, multiply_add(z2, 0.406718052498846252698F, 0.577440339438736392009F),
                                  2.88539009343309178325F);
  const float odd = multiply_add(z2, 0.403343858251329912514F, 0.961791550404184197881F);
  const float result = multiply_add(y, multiply_add(odd, z, even), exponent);
  if (x > 0.0F) [[likely]]
    return x < infinity ? result : infinity;
  return x == 0.0F ? -infinity : nan;
}

SHADERTWIN_INLINE float exp_of(float x) {
  return exp2_of(x * 1.44269504088896340736F);
}
SHADERTWIN_INLINE float log_of(float x) {
  return log2_of(x) * 0.69314718055994530942F;
}

// A NaN counts as equal to 0 here.
SHADERTWIN_INLINE float pow_of(float x, float y) {
  const float power = exp2_of(log2_of(x) * y);
  return x < 0.0F || x > 0.0F ? power : 0.0F;
}

}  // namespace detail

#endif

SHADERTWIN_INLINE Float exp2(Float x) {
  return detail::exp2_of(x);
}
SHADERTWIN_INLINE Float exp(Float x) {
  return detail::exp_of(x);
}
SHADERTWIN_INLINE Float log2(Float x) {
  SHADERTWIN_PROBE(x <= 0, log_not_positive);
  return detail::log2_of(x);
}
SHADERTWIN_INLINE Float log(Float x) {
  SHADERTWIN_PROBE(x <= 0, log_not_positive);
  return detail::log_of(x);
}
SHADERTWIN_INLINE Float pow(Float x, Float y) {
  SHADERTWIN_PROBE(x < 0, pow_negative_base);
  SHADERTWIN_PROBE(x == 0 && y <= 0, pow_zero_base);
  return detail::pow_of(x, y);
}
SHADERTWIN_MAP_1(exp2, vec, vec)
SHADERTWIN_MAP_1(exp, vec, vec)
SHADERTWIN_MAP_1(log2, vec, vec)
SHADERTWIN_MAP_1(log, vec, vec)
SHADERTWIN_MAP_2(pow, vec, vec, vec)

}  // namespace shadertwin::glsl
