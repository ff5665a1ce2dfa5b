// Angles and hyperbolic functions.
//
// As float they compute what Mesa 22.3's llvmpipe computes, operation by operation: sine and cosine from
// gallivm's lp_bld_arit.c, the others as Mesa's GLSL front end and NIR write them out. As double they are
// libm's.
#pragma once

#include "reference/glsl/exponential.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

namespace detail {

#ifdef SHADERTWIN_DOUBLE

#define SHADERTWIN_LIBM(name)          \
  template <class F>                   \
  SHADERTWIN_INLINE F name##_of(F x) { \
    return std::name(x);               \
  }
SHADERTWIN_LIBM(sin)
SHADERTWIN_LIBM(cos)
SHADERTWIN_LIBM(tan)
SHADERTWIN_LIBM(asin)
SHADERTWIN_LIBM(acos)
SHADERTWIN_LIBM(atan)
SHADERTWIN_LIBM(sinh)
SHADERTWIN_LIBM(cosh)
SHADERTWIN_LIBM(tanh)
SHADERTWIN_LIBM(asinh)
SHADERTWIN_LIBM(acosh)
SHADERTWIN_LIBM(atanh)
#undef SHADERTWIN_LIBM
template <class F>
SHADERTWIN_INLINE F atan2_of(F y, F x) {
  return std::atan2(y, x);
}

#else

// Cephes' sinf and cosf: reduction by multiples of pi/4 in three steps, a polynomial for each half octant.
template <bool cosine, class F>
inline F sine_or_cosine(F a) {
  const F magnitude = magnitude_of(a);
  const Unsigned<F> octant = std::bit_cast<Unsigned<F>>(to_int(magnitude * 1.27323954473516F)) + 1U;
  const Unsigned<F> even_octant = octant & ~1U;
  const Unsigned<F> quadrant = cosine ? even_octant - 2U : even_octant;
  const Unsigned<F> sign = cosine ? (~quadrant & 4U) << 29 : (bits(a) ^ (octant << 29)) & 0x80000000U;

  const F y = to_float(std::bit_cast<Signed<F>>(even_octant));
  F x = multiply_add(y, constant<F>(-0.78515625F), magnitude);
  x = multiply_add(y, constant<F>(-2.4187564849853515625e-4F), x);
  x = multiply_add(y, constant<F>(-3.77489497744594108e-8F), x);
  const F z = x * x;

  F c = multiply_add(z, constant<F>(2.443315711809948e-5F), constant<F>(-1.388731625493765e-3F));
  c = multiply_add(c, z, constant<F>(4.166664568298827e-2F));
  const F cosine_part = c * z * z - z * 0.5F + 1.0F;
  F s = multiply_add(z, constant<F>(-1.9515295891e-4F), constant<F>(8.3321608736e-3F));
  s = multiply_add(s, z, constant<F>(-1.6666654611e-1F));
  const F sine_part = multiply_add(s * z, x, x);

  F result = select((quadrant & 2U) == 0U, sine_part, cosine_part);
  result = first_if_less(from_bits<F>(bits(result) ^ sign), constant<F>(1.0F));
  result = first_if_greater(result, constant<F>(-1.0F));
  return select(magnitude < infinity, result, constant<F>(nan));
}

template <class F>
SHADERTWIN_INLINE F sin_of(F x) {
  return sine_or_cosine<false, F>(x);
}
template <class F>
SHADERTWIN_INLINE F cos_of(F x) {
  return sine_or_cosine<true, F>(x);
}
template <class F>
SHADERTWIN_INLINE F tan_of(F x) {
  return sin_of<F>(x) / cos_of<F>(x);
}

// 0 for 0 of either sign and for a NaN.
template <class F>
SHADERTWIN_INLINE F sign_of(F x) {
  return select(x > 0.0F, constant<F>(1.0F), select(x < 0.0F, constant<F>(-1.0F), constant<F>(0.0F)));
}

template <class F>
SHADERTWIN_INLINE F asin_with(F x, float p0, float p1) {
  const F m = magnitude_of(x);
  const F p = half_pi + m * ((0.785398163397448309616F - 1.0F) + m * (p0 + m * p1));
  return sign_of<F>(x) * (half_pi - root(1.0F - m) * p);
}
template <class F>
SHADERTWIN_OUTLINE F asin_of(F x) {
  return asin_with<F>(x, 0.086566724F, -0.03102955F);
}
template <class F>
SHADERTWIN_OUTLINE F acos_of(F x) {
  return half_pi - asin_with<F>(x, 0.08132463F, -0.02363318F);
}

// The last product is associated as Mesa's optimiser does it: nothing else uses x^11.
template <class F>
SHADERTWIN_OUTLINE F atan_of(F y_over_x) {
  const F m = magnitude_of(y_over_x);
  const F one = constant<F>(1.0F);
  const F x = first_if_less(m, one) / first_if_greater(m, one);
  const F x2 = x * x;
  const F x3 = x2 * x;
  const F x5 = x3 * x2;
  const F x7 = x5 * x2;
  const F x9 = x7 * x2;
  const F angle = x * 0.9999793128310355F + x3 * -0.3326756418091246F + x5 * 0.1938924977115610F +
                  x7 * -0.1173503194786851F + x9 * 0.0536813784310406F + (x9 * -0.0121323213173444F) * x2;
  return select(m > 1.0F, (angle * -2.0F + half_pi) + angle, angle) * sign_of<F>(y_over_x);
}

// The left half-plane is turned by pi/2, so that no division by zero lies along x = 0.
template <class F>
SHADERTWIN_OUTLINE F atan2_of(F y, F x) {
  const auto flip = x <= 0.0F;
  const F s = select(flip, magnitude_of(x), y);
  const F t = select(flip, y, magnitude_of(x));
  const F scale = select(magnitude_of(t) >= 1e18F, constant<F>(0.25F), constant<F>(1.0F));
  const F reciprocal = 1.0F / (t * scale);
  const F s_over_t = (s * scale) * reciprocal;
  const F tangent = select(magnitude_of(x) == magnitude_of(y), constant<F>(1.0F), magnitude_of(s_over_t));
  const F arc = select(flip, constant<F>(half_pi), constant<F>(0.0F)) + atan_of<F>(tangent);
  return select((y < 0.0F) | (reciprocal < 0.0F), negated(arc), arc);
}

template <class F>
SHADERTWIN_OUTLINE F sinh_of(F x) {
  return 0.5F * (exp_of<F>(x) - exp_of<F>(negated(x)));
}
template <class F>
SHADERTWIN_OUTLINE F cosh_of(F x) {
  return 0.5F * (exp_of<F>(x) + exp_of<F>(negated(x)));
}
template <class F>
SHADERTWIN_OUTLINE F tanh_of(F x) {
  const F t = first_if_less(first_if_greater(x, constant<F>(-10.0F)), constant<F>(10.0F));
  const F up = exp_of<F>(t);
  const F down = exp_of<F>(negated(t));
  return (up - down) / (up + down);
}
template <class F>
SHADERTWIN_OUTLINE F asinh_of(F x) {
  return sign_of<F>(x) * log_of<F>(magnitude_of(x) + root(x * x + 1.0F));
}
template <class F>
SHADERTWIN_OUTLINE F acosh_of(F x) {
  return log_of<F>(x + root(x * x - 1.0F));
}
template <class F>
SHADERTWIN_OUTLINE F atanh_of(F x) {
  return 0.5F * log_of<F>((1.0F + x) / (1.0F - x));
}

#endif

}  // namespace detail

SHADERTWIN_INLINE Float radians(Float degrees) {
  return degrees * Float(0.017453292519943295769);
}
SHADERTWIN_INLINE Float degrees(Float radians) {
  return radians * Float(57.295779513082320877);
}
SHADERTWIN_INLINE Float sin(Float x) {
  return SHADERTWIN_APPLY_1(Float, sin_of, x);
}
SHADERTWIN_INLINE Float cos(Float x) {
  return SHADERTWIN_APPLY_1(Float, cos_of, x);
}
SHADERTWIN_INLINE Float tan(Float x) {
  return SHADERTWIN_APPLY_1(Float, tan_of, x);
}
SHADERTWIN_INLINE Float asin(Float x) {
  SHADERTWIN_PROBE(x < -1 || x > 1, asin_beyond_one);
  return SHADERTWIN_APPLY_1(Float, asin_of, x);
}
SHADERTWIN_INLINE Float acos(Float x) {
  SHADERTWIN_PROBE(x < -1 || x > 1, acos_beyond_one);
  return SHADERTWIN_APPLY_1(Float, acos_of, x);
}
SHADERTWIN_INLINE Float atan(Float y_over_x) {
  return SHADERTWIN_APPLY_1(Float, atan_of, y_over_x);
}
SHADERTWIN_INLINE Float atan(Float y, Float x) {
  SHADERTWIN_PROBE(x == 0 && y == 0, atan_of_zeros);
  return SHADERTWIN_APPLY_2(Float, atan2_of, y, x);
}
SHADERTWIN_INLINE Float sinh(Float x) {
  return SHADERTWIN_APPLY_1(Float, sinh_of, x);
}
SHADERTWIN_INLINE Float cosh(Float x) {
  return SHADERTWIN_APPLY_1(Float, cosh_of, x);
}
SHADERTWIN_INLINE Float tanh(Float x) {
  return SHADERTWIN_APPLY_1(Float, tanh_of, x);
}
SHADERTWIN_INLINE Float asinh(Float x) {
  return SHADERTWIN_APPLY_1(Float, asinh_of, x);
}
SHADERTWIN_INLINE Float acosh(Float x) {
  SHADERTWIN_PROBE(x < 1, acosh_below_one);
  return SHADERTWIN_APPLY_1(Float, acosh_of, x);
}
SHADERTWIN_INLINE Float atanh(Float x) {
  SHADERTWIN_PROBE(x <= -1 || x >= 1, atanh_beyond_one);
  return SHADERTWIN_APPLY_1(Float, atanh_of, x);
}
SHADERTWIN_MAP_1(radians, vec, vec)
SHADERTWIN_MAP_1(degrees, vec, vec)
SHADERTWIN_SPREAD_1(sin, sin_of)
SHADERTWIN_SPREAD_1(cos, cos_of)
SHADERTWIN_SPREAD_1(tan, tan_of)
SHADERTWIN_SPREAD_1(asin, asin_of)
SHADERTWIN_SPREAD_1(acos, acos_of)
SHADERTWIN_SPREAD_1(atan, atan_of)
SHADERTWIN_SPREAD_2(atan, atan2_of)
SHADERTWIN_SPREAD_1(sinh, sinh_of)
SHADERTWIN_SPREAD_1(cosh, cosh_of)
SHADERTWIN_SPREAD_1(tanh, tanh_of)
SHADERTWIN_SPREAD_1(asinh, asinh_of)
SHADERTWIN_SPREAD_1(acosh, acosh_of)
SHADERTWIN_SPREAD_1(atanh, atanh_of)

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
