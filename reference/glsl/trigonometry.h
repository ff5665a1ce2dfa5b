// Angles and hyperbolic functions of any number type.
//
// As float they compute what Mesa 22.3's llvmpipe computes, operation by operation: sine and cosine from
// gallivm's lp_bld_arit.c, the others as Mesa's GLSL front end and NIR write them out. As double they are
// libm's.
#pragma once

#include "reference/glsl/common.h"
#include "reference/glsl/exponential.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

constexpr double half_pi = 1.57079632679489661923;

template <class F>
SHADERTWIN_INLINE F radians_of(F degrees) {
  return degrees * constant<F>(0.017453292519943295769);
}
template <class F>
SHADERTWIN_INLINE F degrees_of(F radians) {
  return radians * constant<F>(57.295779513082320877);
}

// --- Angles -----------------------------------------------------------------

// Cephes' sinf and cosf: reduction by multiples of pi/4 in three steps, a polynomial for each half octant.
template <bool cosine, class F>
inline std::same_as<F> auto sine_or_cosine(F a) {
  const F magnitude = magnitude_of(a);
  const Unsigned<F> octant = std::bit_cast<Unsigned<F>>(to_int(magnitude * 1.27323954473516F)) + 1U;
  const Unsigned<F> even_octant = octant & ~1U;
  const Unsigned<F> quadrant = cosine ? even_octant - 2U : even_octant;
  const Unsigned<F> sign = cosine ? (~quadrant & 4U) << 29 : (bits(a) ^ (octant << 29)) & 0x80000000U;

  const F y = from_int<F>(std::bit_cast<Signed<F>>(even_octant));
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

  F result = select__((quadrant & 2U) == 0U, sine_part, cosine_part);
  result = first_if_less(from_bits<F>(bits(result) ^ sign), constant<F>(1.0F));
  result = first_if_greater(result, constant<F>(-1.0F));
  return select__(magnitude < constant<F>(infinity), result, constant<F>(nan));
}

template <class F>
SHADERTWIN_INLINE std::same_as<F> auto sin_of(F x) {
  if constexpr (uses_libm<F>)
    return std::sin(x);
  else
    return sine_or_cosine<false, F>(x);
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto cos_of(F x) {
  if constexpr (uses_libm<F>)
    return std::cos(x);
  else
    return sine_or_cosine<true, F>(x);
}
template <class F>
SHADERTWIN_INLINE F tan_of(F x) {
  if constexpr (uses_libm<F>)
    return std::tan(x);
  else
    return sin_of(x) / cos_of(x);
}

template <class F>
SHADERTWIN_INLINE std::same_as<F> auto asin_with(F x, float p0, float p1) {
  const F m = magnitude_of(x);
  const F p = constant<F>(half_pi) + m * ((0.785398163397448309616F - 1.0F) + m * (p0 + m * p1));
  return sign_of(x) * (constant<F>(half_pi) - root(1.0F - m) * p);
}
template <class F>
SHADERTWIN_OUTLINE F asin_of(F x) {
  SHADERTWIN_PROBE(x < -1.0F || x > 1.0F, asin_beyond_one);
  if constexpr (uses_libm<F>)
    return std::asin(x);
  else
    return asin_with<F>(x, 0.086566724F, -0.03102955F);
}
template <class F>
SHADERTWIN_OUTLINE F acos_of(F x) {
  SHADERTWIN_PROBE(x < -1.0F || x > 1.0F, acos_beyond_one);
  if constexpr (uses_libm<F>)
    return std::acos(x);
  else
    return constant<F>(half_pi) - asin_with<F>(x, 0.08132463F, -0.02363318F);
}

// Mesa's optimiser associates the last product in its own way, since nothing else uses x^11, but not where
// the text is `precise`: strict.
template <bool strict, class F>
SHADERTWIN_INLINE F arc_of(F y_over_x) {
  if constexpr (uses_libm<F>) {
    return std::atan(y_over_x);
  } else {
    const F m = magnitude_of(y_over_x);
    const F one = constant<F>(1.0F);
    const F x = first_if_less(m, one) / first_if_greater(m, one);
    const F x2 = x * x;
    const F x3 = x2 * x;
    const F x5 = x3 * x2;
    const F x7 = x5 * x2;
    const F x9 = x7 * x2;
    const F last = strict ? (x9 * x2) * -0.0121323213173444F : (x9 * -0.0121323213173444F) * x2;
    const F angle = x * 0.9999793128310355F + x3 * -0.3326756418091246F + x5 * 0.1938924977115610F +
                    x7 * -0.1173503194786851F + x9 * 0.0536813784310406F + last;
    return select__(m > 1.0F, (angle * -2.0F + constant<F>(half_pi)) + angle, angle) * sign_of(y_over_x);
  }
}

// The left half-plane is turned by pi/2, so that no division by zero lies along x = 0. Of two zeros: 0.
template <bool strict, class F>
SHADERTWIN_INLINE F arc_of(F y, F x) {
  SHADERTWIN_PROBE(x == 0.0F && y == 0.0F, atan_of_zeros);
  if constexpr (uses_libm<F>) {
    return x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x);
  } else {
    const auto flip = x <= 0.0F;
    const F s = select__(flip, magnitude_of(x), y);
    const F t = select__(flip, y, magnitude_of(x));
    const F scale = select__(magnitude_of(t) >= 1e18F, constant<F>(0.25F), constant<F>(1.0F));
    const F reciprocal = 1.0F / (t * scale);
    const F s_over_t = (s * scale) * reciprocal;
    const F tangent = select__(magnitude_of(x) == magnitude_of(y), constant<F>(1.0F), magnitude_of(s_over_t));
    const F arc = select__(flip, constant<F>(half_pi), constant<F>(0.0F)) + arc_of<strict>(tangent);
    const F angle = select__((y < 0.0F) | (reciprocal < 0.0F), -arc, arc);
    return select__(x == 0.0F, select__(y == 0.0F, constant<F>(0.0F), angle), angle);
  }
}

template <class F>
SHADERTWIN_OUTLINE F atan_of(F y_over_x) {
  return arc_of<false>(y_over_x);
}
template <class F>
SHADERTWIN_OUTLINE F atan_of(F y, F x) {
  return arc_of<false>(y, x);
}
template <class F>
SHADERTWIN_OUTLINE F atan_strict_of(F y_over_x) {
  return arc_of<true>(y_over_x);
}
template <class F>
SHADERTWIN_OUTLINE F atan_strict_of(F y, F x) {
  return arc_of<true>(y, x);
}

template <class F>
SHADERTWIN_OUTLINE F sinh_of(F x) {
  if constexpr (uses_libm<F>)
    return std::sinh(x);
  else
    return 0.5F * (exp_of(x) - exp_of(-x));
}
template <class F>
SHADERTWIN_OUTLINE F cosh_of(F x) {
  if constexpr (uses_libm<F>)
    return std::cosh(x);
  else
    return 0.5F * (exp_of(x) + exp_of(-x));
}
template <class F>
SHADERTWIN_OUTLINE F tanh_of(F x) {
  if constexpr (uses_libm<F>) {
    return std::tanh(x);
  } else {
    const F t = first_if_less(first_if_greater(x, constant<F>(-10.0F)), constant<F>(10.0F));
    const F up = exp_of(t);
    const F down = exp_of(-t);
    return (up - down) / (up + down);
  }
}
template <class F>
SHADERTWIN_OUTLINE F asinh_of(F x) {
  if constexpr (uses_libm<F>)
    return std::asinh(x);
  else
    return sign_of(x) * natural_logarithm(magnitude_of(x) + root(x * x + 1.0F));
}
template <class F>
SHADERTWIN_OUTLINE F acosh_of(F x) {
  SHADERTWIN_PROBE(x < 1.0F, acosh_below_one);
  if constexpr (uses_libm<F>)
    return std::acosh(x);
  else
    return natural_logarithm(x + root(x * x - 1.0F));
}
template <class F>
SHADERTWIN_OUTLINE F atanh_of(F x) {
  SHADERTWIN_PROBE(x <= -1.0F || x >= 1.0F, atanh_beyond_one);
  if constexpr (uses_libm<F>)
    return std::atanh(x);
  else
    return 0.5F * natural_logarithm((1.0F + x) / (1.0F - x));
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
