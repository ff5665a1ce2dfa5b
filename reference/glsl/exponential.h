// Roots, exponentials and logarithms of any number type.
//
// As float they compute what Mesa 22.3's llvmpipe computes, operation by operation (the polynomials of
// gallivm's lp_bld_arit.c, fused where the processor can, as there), so that both have the same bits. As
// double they are libm's, with GLSL's domains.
#pragma once

#include "reference/glsl/lanes.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// --- Roots ------------------------------------------------------------------

template <class F>
SHADERTWIN_INLINE F sqrt_of(F x) {
  SHADERTWIN_PROBE(x < 0.0F, sqrt_negative);
  return root(x);
}
template <class F>
SHADERTWIN_INLINE F inversesqrt_of(F x) {
  SHADERTWIN_PROBE(x <= 0.0F, inversesqrt_not_positive);
  return 1.0F / root(x);
}

// --- Exponentials -----------------------------------------------------------

// 2^floor(x) from the exponent's bits times a polynomial of degree 5 for the rest. Below 2^-126 it is 0.
template <class F>
inline F exp2_of(F x) {
  if constexpr (uses_libm<F>) {
    return std::exp2(x);
  } else {
    x = first_if_less(constant<F>(128.0F), x);
    x = first_if_greater(constant<F>(-126.99999F), x);
    const F whole = round_down(x);
    const F f = x - whole;
    const F scale = from_bits<F>((std::bit_cast<Unsigned<F>>(to_int(whole)) + 127U) << 23);
    const F f2 = f * f;
    F even = multiply_add(f2, constant<F>(0.00898934009049466391101F), constant<F>(0.240153617044375388211F));
    even = multiply_add(f2, even, constant<F>(1.0F));
    F odd = multiply_add(f2, constant<F>(0.00187757667519147912699F), constant<F>(0.0558263180532956664775F));
    odd = multiply_add(f2, odd, constant<F>(0.693153073200168932794F));
    return scale * multiply_add(odd, f, even);
  }
}

template <class F>
SHADERTWIN_INLINE F exp_of(F x) {
  if constexpr (uses_libm<F>)
    return std::exp(x);
  else
    return exp2_of(x * 1.44269504088896340736F);
}

// --- Logarithms -------------------------------------------------------------

// The exponent plus log2 of the mantissa m in [1, 2), as a polynomial of ((m - 1) / (m + 1))^2.
template <class F>
inline std::same_as<F> auto binary_logarithm(F x) {
  if constexpr (uses_libm<F>) {
    return std::log2(x);
  } else {
    const Unsigned<F> pattern = bits(x);
    const F exponent = from_int<F>(std::bit_cast<Signed<F>>(((pattern & 0x7f800000U) >> 23) - 127U));
    const F m = from_bits<F>((pattern & 0x007fffffU) | 0x3f800000U);
    const F y = (m - 1.0F) / (m + 1.0F);
    const F z = y * y;
    const F z2 = z * z;
    F even = multiply_add(z2, constant<F>(0.406718052498846252698F), constant<F>(0.577440339438736392009F));
    even = multiply_add(z2, even, constant<F>(2.88539009343309178325F));
    const F odd =
        multiply_add(z2, constant<F>(0.403343858251329912514F), constant<F>(0.961791550404184197881F));
    F result = multiply_add(y, multiply_add(odd, z, even), exponent);
    result = select__(x < constant<F>(infinity), result, constant<F>(infinity));
    const F otherwise = select__(x == 0.0F, constant<F>(-infinity), constant<F>(nan));
    return select__(x > 0.0F, result, otherwise);
  }
}

template <class F>
SHADERTWIN_INLINE std::same_as<F> auto natural_logarithm(F x) {
  if constexpr (uses_libm<F>)
    return std::log(x);
  else
    return binary_logarithm(x) * 0.69314718055994530942F;
}

template <class F>
SHADERTWIN_INLINE F log2_of(F x) {
  SHADERTWIN_PROBE(x <= 0.0F, log_not_positive);
  return binary_logarithm(x);
}
template <class F>
SHADERTWIN_INLINE F log_of(F x) {
  SHADERTWIN_PROBE(x <= 0.0F, log_not_positive);
  return natural_logarithm(x);
}

// 1 for y = 0, whatever x is; 0 for the other powers of a NaN.
template <class F>
SHADERTWIN_INLINE F pow_of(F x, F y) {
  SHADERTWIN_PROBE(x < 0.0F, pow_negative_base);
  SHADERTWIN_PROBE(x == 0.0F && y <= 0.0F, pow_zero_base);
  if constexpr (uses_libm<F>) {
    return y == 0.0 || x == 0.0 ? std::pow(std::fabs(x), y) : x > 0.0 ? std::pow(x, y) : nan;
  } else {
    const F power = exp2_of(binary_logarithm(x) * y);
    const F of_zero = select__(y < 0.0F, constant<F>(infinity), constant<F>(0.0F));
    const F of_others = select__((x < 0.0F) | (x > 0.0F), power, constant<F>(0.0F));
    return select__(y == 0.0F, constant<F>(1.0F), select__(x == 0.0F, of_zero, of_others));
  }
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
