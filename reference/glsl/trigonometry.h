// Angles and hyperbolic functions.
//
// As float they compute what Mesa 22.3's llvmpipe computes, operation by operation: sine and cosine from
// gallivm's lp_bld_arit.c, the others as Mesa's GLSL front end and NIR write them out. As double they are
// libm's.
#pragma once

#include "reference/glsl/exponential.h"

namespace shadertwin::glsl {

#ifdef SHADERTWIN_DOUBLE

namespace detail {
SHADERTWIN_INLINE double sin_of(double x) {
  return std::sin(x);
}
SHADERTWIN_INLINE double cos_of(double x) {
  return std::cos(x);
}
SHADERTWIN_INLINE double tan_of(double x) {
  return std::tan(x);
}
SHADERTWIN_INLINE double asin_of(double x) {
  return std::asin(x);
}
SHADERTWIN_INLINE double acos_of(double x) {
  return std::acos(x);
}
SHADERTWIN_INLINE double atan_of(double x) {
  return std::atan(x);
}
SHADERTWIN_INLINE double atan_of(double y, double x) {
  return std::atan2(y, x);
}
SHADERTWIN_INLINE double sinh_of(double x) {
  return std::sinh(x);
}
SHADERTWIN_INLINE double cosh_of(double x) {
  return std::cosh(x);
}
SHADERTWIN_INLINE double tanh_of(double x) {
  return std::tanh(x);
}
SHADERTWIN_INLINE double asinh_of(double x) {
  return std::asinh(x);
}
SHADERTWIN_INLINE double acosh_of(double x) {
  return std::acosh(x);
}
SHADERTWIN_INLINE double atanh_of(double x) {
  return std::atanh(x);
}
}  // namespace detail

#else

namespace detail {

// Cephes' sinf and cosf: reduction by multiples of pi/4 in three steps, a polynomial for each half octant.
template <bool cosine>
inline float sine_or_cosine(float a) {
  const float magnitude = std::fabs(a);
  const int octant = static_cast<int>(static_cast<uint>(truncate(magnitude * 1.27323954473516F)) + 1U);
  const int even_octant = octant & ~1;
  const float y = static_cast<float>(even_octant);
  const int quadrant = cosine ? static_cast<int>(static_cast<uint>(even_octant) - 2U) : even_octant;
  const uint sign = cosine ? (~static_cast<uint>(quadrant) & 4U) << 29
                           : (bits(a) ^ (static_cast<uint>(octant) << 29)) & 0x80000000U;

  float x = multiply_add(y, -0.78515625F, magnitude);
  x = multiply_add(y, -2.4187564849853515625e-4F, x);
  x = multiply_add(y, -3.77489497744594108e-8F, x);
  const float z = x * x;

  const float c =
      multiply_add(multiply_add(z, 2.443315711809948e-5F, -1.388731625493765e-3F), z, 4.166664568298827e-2F);
  const float cosine_part = c * z * z - z * 0.5F + 1.0F;
  const float s = multiply_add(multiply_add(z, -1.9515295891e-4F, 8.3321608736e-3F), z, -1.6666654611e-1F);
  const float sine_part = multiply_add(s * z, x, x);

  const float part = (quadrant & 2) == 0 ? sine_part : cosine_part;
  const float result = first_if_greater(first_if_less(from_bits(bits(part) ^ sign), 1.0F), -1.0F);
  return magnitude < infinity ? result : nan;
}

SHADERTWIN_INLINE float sin_of(float x) {
  return sine_or_cosine<false>(x);
}
SHADERTWIN_INLINE float cos_of(float x) {
  return sine_or_cosine<true>(x);
}
SHADERTWIN_INLINE float tan_of(float x) {
  return sin_of(x) / cos_of(x);
}

// 0 for 0 of either sign and for a NaN.
SHADERTWIN_INLINE float sign_of(float x) {
  return x > 0.0F ? 1.0F : x < 0.0F ? -1.0F : 0.0F;
}

SHADERTWIN_INLINE float asin_with(float x, float p0, float p1) {
  const float m = std::fabs(x);
  return sign_of(x) * (half_pi - std::sqrt(1.0F - m) *
                                     (half_pi + m * ((0.785398163397448309616F - 1.0F) + m * (p0 + m * p1))));
}
inline float asin_of(float x) {
  return asin_with(x, 0.086566724F, -0.03102955F);
}
inline float acos_of(float x) {
  return half_pi - asin_with(x, 0.08132463F, -0.02363318F);
}

inline float atan_of(float y_over_x) {
  const float m = std::fabs(y_over_x);
  const float x = (m < 1.0F ? m : 1.0F) / (m > 1.0F ? m : 1.0F);
  const float x2 = x * x;
  const float x3 = x2 * x;
  const float x5 = x3 * x2;
  const float x7 = x5 * x2;
  const float x9 = x7 * x2;
  float angle = x * 0.9999793128310355F + x3 * -0.3326756418091246F + x5 * 0.1938924977115610F +
                x7 * -0.1173503194786851F + x9 * 0.0536813784310406F + (x9 * -0.0121323213173444F) * x2;
  if (m > 1.0F) angle = (angle * -2.0F + half_pi) + angle;
  return angle * sign_of(y_over_x);
}

// The left half-plane is turned by pi/2, so that no division by zero lies along x = 0.
inline float atan_of(float y, float x) {
  const bool flip = 0.0F >= x;
  const float s = flip ? std::fabs(x) : y;
  const float t = flip ? y : std::fabs(x);
  const float scale = std::fabs(t) >= 1e18F ? 0.25F : 1.0F;
  const float reciprocal = 1.0F / (t * scale);
  const float s_over_t = (s * scale) * reciprocal;
  const float tangent = std::fabs(x) == std::fabs(y) ? 1.0F : std::fabs(s_over_t);
  const float arc = (flip ? half_pi : 0.0F) + atan_of(tangent);
  return y < 0.0F || reciprocal < 0.0F ? -arc : arc;
}

inline float sinh_of(float x) {
  return 0.5F * (exp_of(x) - exp_of(-x));
}
inline float cosh_of(float x) {
  return 0.5F * (exp_of(x) + exp_of(-x));
}
inline float tanh_of(float x) {
  const float t = first_if_less(first_if_greater(x, -10.0F), 10.0F);
  const float up = exp_of(t);
  const float down = exp_of(-t);
  return (up - down) / (up + down);
}
inline float asinh_of(float x) {
  return sign_of(x) * log_of(std::fabs(x) + std::sqrt(x * x + 1.0F));
}
inline float acosh_of(float x) {
  return log_of(x + std::sqrt(x * x - 1.0F));
}
inline float atanh_of(float x) {
  return 0.5F * log_of((1.0F + x) / (1.0F - x));
}

}  // namespace detail

#endif

SHADERTWIN_INLINE Float radians(Float degrees) {
  return degrees * Float(0.017453292519943295769);
}
SHADERTWIN_INLINE Float degrees(Float radians) {
  return radians * Float(57.295779513082320877);
}
SHADERTWIN_INLINE Float sin(Float x) {
  return detail::sin_of(x);
}
SHADERTWIN_INLINE Float cos(Float x) {
  return detail::cos_of(x);
}
SHADERTWIN_INLINE Float tan(Float x) {
  return detail::tan_of(x);
}
SHADERTWIN_INLINE Float asin(Float x) {
  SHADERTWIN_PROBE(x < -1 || x > 1, asin_beyond_one);
  return detail::asin_of(x);
}
SHADERTWIN_INLINE Float acos(Float x) {
  SHADERTWIN_PROBE(x < -1 || x > 1, acos_beyond_one);
  return detail::acos_of(x);
}
SHADERTWIN_INLINE Float atan(Float y_over_x) {
  return detail::atan_of(y_over_x);
}
SHADERTWIN_INLINE Float atan(Float y, Float x) {
  SHADERTWIN_PROBE(x == 0 && y == 0, atan_of_zeros);
  return detail::atan_of(y, x);
}
SHADERTWIN_INLINE Float sinh(Float x) {
  return detail::sinh_of(x);
}
SHADERTWIN_INLINE Float cosh(Float x) {
  return detail::cosh_of(x);
}
SHADERTWIN_INLINE Float tanh(Float x) {
  return detail::tanh_of(x);
}
SHADERTWIN_INLINE Float asinh(Float x) {
  return detail::asinh_of(x);
}
SHADERTWIN_INLINE Float acosh(Float x) {
  SHADERTWIN_PROBE(x < 1, acosh_below_one);
  return detail::acosh_of(x);
}
SHADERTWIN_INLINE Float atanh(Float x) {
  SHADERTWIN_PROBE(x <= -1 || x >= 1, atanh_beyond_one);
  return detail::atanh_of(x);
}
SHADERTWIN_MAP_1(radians, vec, vec)
SHADERTWIN_MAP_1(degrees, vec, vec)
SHADERTWIN_MAP_1(sin, vec, vec)
SHADERTWIN_MAP_1(cos, vec, vec)
SHADERTWIN_MAP_1(tan, vec, vec)
SHADERTWIN_MAP_1(asin, vec, vec)
SHADERTWIN_MAP_1(acos, vec, vec)
SHADERTWIN_MAP_1(atan, vec, vec)
SHADERTWIN_MAP_2(atan, vec, vec, vec)
SHADERTWIN_MAP_1(sinh, vec, vec)
SHADERTWIN_MAP_1(cosh, vec, vec)
SHADERTWIN_MAP_1(tanh, vec, vec)
SHADERTWIN_MAP_1(asinh, vec, vec)
SHADERTWIN_MAP_1(acosh, vec, vec)
SHADERTWIN_MAP_1(atanh, vec, vec)

}  // namespace shadertwin::glsl
