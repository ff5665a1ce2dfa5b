// GLSL's common functions for any number type: rounding, comparison, blending, classification, and the bits
// of floats.
#pragma once

#include "reference/glsl/lanes.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// --- Magnitude and rounding -------------------------------------------------

template <class T>
SHADERTWIN_INLINE T abs_of(T x) {
  if constexpr (is_integer<T>)
    return select__(x < T{}, -x, x);
  else
    return magnitude_of(x);
}
// 0 for zeros of either sign and, as llvmpipe has it, for a NaN.
template <class T>
SHADERTWIN_INLINE T sign_of(T x) {
  return select__(x > T{}, constant<T>(1), select__(x < T{}, constant<T>(-1), T{}));
}
template <class F>
SHADERTWIN_INLINE F floor_of(F x) {
  return round_down(x);
}
template <class F>
SHADERTWIN_INLINE F ceil_of(F x) {
  return round_up(x);
}
template <class F>
SHADERTWIN_INLINE F trunc_of(F x) {
  return round_to_zero(x);
}
template <class F>
SHADERTWIN_INLINE F roundEven_of(F x) {
  return round_to_even(x);
}
// Mesa rounds halves to even here too.
template <class F>
SHADERTWIN_INLINE F round_of(F x) {
  return round_to_even(x);
}
template <class F>
SHADERTWIN_INLINE F fract_of(F x) {
  return x - round_down(x);
}
// By zero: x.
template <class F>
SHADERTWIN_INLINE F mod_of(F x, F y) {
  SHADERTWIN_PROBE(y == 0.0F, mod_by_zero);
  return select__(y == 0.0F, x, x - y * round_down(x / y));
}
template <class F>
SHADERTWIN_INLINE F modf_of(F x, F& whole) {
  whole = round_to_zero(x);
  return x - whole;
}

// --- Smaller and larger -----------------------------------------------------

// The other operand if one is a NaN; of two zeros the second.
template <class T>
SHADERTWIN_INLINE T min_of(T a, T b) {
  return select__(unlikely(b != b), a, first_if_less(a, b));
}
template <class T>
SHADERTWIN_INLINE T max_of(T a, T b) {
  return select__(unlikely(b != b), a, first_if_greater(a, b));
}
template <class T>
SHADERTWIN_INLINE T clamp_of(T x, T low, T high) {
  SHADERTWIN_PROBE(low > high, clamp_crossed);
  return min_of(max_of(x, low), high);
}

// --- Blending ---------------------------------------------------------------

template <class F>
SHADERTWIN_INLINE F mix_of(F a, F b, F t) {
  return a + t * (b - a);
}
template <class F>
SHADERTWIN_INLINE F mix_of(F a, F b, Mask<F> second) {
  return select__(second, b, a);
}
// What Mesa makes of mix() that is `precise`, or whose t is a constant, or whose b is the constant 1 or -1.
template <class F>
SHADERTWIN_INLINE F mix_strict_of(F a, F b, F t) {
  return a * (1.0F - t) + b * t;
}
template <class F>
SHADERTWIN_INLINE F step_of(F edge, F x) {
  return select__(x >= edge, constant<F>(1), constant<F>(0));
}
// Of equal edges a step behind them.
template <class F>
SHADERTWIN_INLINE F smoothstep_of(F edge0, F edge1, F x) {
  SHADERTWIN_PROBE(edge0 >= edge1, smoothstep_crossed);
  const F t = min_of(max_of((x - edge0) / (edge1 - edge0), constant<F>(0)), constant<F>(1));
  const F at_once = select__(x > edge0, constant<F>(1), constant<F>(0));
  return select__(edge0 == edge1, at_once, t * (t * (3.0F - 2.0F * t)));
}

// --- Classification and bits ------------------------------------------------

template <class F>
SHADERTWIN_INLINE Mask<F> isnan_of(F x) {
  return x != x;
}
template <class F>
SHADERTWIN_INLINE Mask<F> isinf_of(F x) {
  return magnitude_of(x) == constant<F>(infinity);
}
template <class F>
SHADERTWIN_INLINE Signed<F> floatBitsToInt_of(F x) {
  return std::bit_cast<Signed<F>>(bits(x));
}
template <class F>
SHADERTWIN_INLINE Unsigned<F> floatBitsToUint_of(F x) {
  return bits(x);
}
template <class F>
SHADERTWIN_INLINE F intBitsToFloat_of(Signed<F> x) {
  return from_bits<F>(std::bit_cast<Unsigned<F>>(x));
}
template <class F>
SHADERTWIN_INLINE F uintBitsToFloat_of(Unsigned<F> x) {
  return from_bits<F>(x);
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
