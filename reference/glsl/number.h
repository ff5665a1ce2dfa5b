// What a type of numbers must provide for GLSL's built-in functions, and float and double as such types. The
// functions are templates over it (exponential.h, trigonometry.h, common.h, geometry.h, matrix.h, integer.h);
// overloads.h turns them into GLSL's overloads. The numbers of this library are float, double, four floats
// (lanes.h), one float for each of eight pixels (packet.h), and a float with a double beside it (shadow.h).
//
// A number type F has
// - NumberTypes<F>: the integers and the result of a comparison that go with it. By default int, uint and
//   bool; they may be several side by side, as F may.
// - + - * / and unary -, < <= > >= == != with a mask as the result, also between F and float.
// - a constructor from double, or the nested type F::Scalar of what it can be made from.
// - the functions that the concept Number lists. What its arguments' namespace declares is found; what float
//   needs no instruction of its own for has a template here: select__, first_if_less, bits, constant ...
//   Each must round as IEEE says, and only multiply_add may be fused.
//
// Steps that take a number to pieces (exponents, octants) ask for the bits of a float. A type that can't give
// them overloads the functions that do so (exp2_of, sin_of ...) before it includes builtins.def, in namespace
// detail; double is such a type, by uses_libm.
#pragma once

#include <bit>
#include <cmath>
#include <limits>

#include "reference/glsl/types.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

template <class F>
struct NumberTypes {
  using Signed = int;
  using Unsigned = uint;
  using Mask = bool;
};
template <class F>
using Signed = typename NumberTypes<F>::Signed;
template <class F>
using Unsigned = typename NumberTypes<F>::Unsigned;
template <class F>
using Mask = typename NumberTypes<F>::Mask;

// Whether the elementary functions are the C library's.
template <class F>
constexpr bool uses_libm = std::is_same_v<F, double>;

// Of the integers that go with numbers too.
template <class T>
constexpr bool is_integer = std::is_integral_v<T>;

// --- What every type has by default -----------------------------------------

template <class T>
SHADERTWIN_INLINE T constant(double x) {
  if constexpr (std::is_constructible_v<T, double>) {
    return static_cast<T>(x);
  } else if constexpr (requires { typename T::Scalar; }) {
    return T(static_cast<typename T::Scalar>(x));
  } else {
    return T{} + static_cast<float>(x);  // a vector of the compiler's
  }
}
// One of two, by what was compared. Both have been computed.
template <class T>
SHADERTWIN_INLINE T select__(bool condition, T a, T b) {
  return condition ? a : b;
}
// For a condition that hardly ever holds.
template <class M>
SHADERTWIN_INLINE M unlikely(M condition) {
  if constexpr (std::is_same_v<M, bool>) {
    return __builtin_expect(static_cast<long>(condition), 0L) != 0;
  } else {
    return condition;
  }
}
// x86's minps and maxps: the second operand if the two are equal or one is a NaN.
template <class T>
SHADERTWIN_INLINE T first_if_less(T a, T b) {
  return select__(a < b, a, b);
}
template <class T>
SHADERTWIN_INLINE T first_if_greater(T a, T b) {
  return select__(a > b, a, b);
}
template <class F>
SHADERTWIN_INLINE Unsigned<F> bits(F x) {
  return std::bit_cast<Unsigned<F>>(x);
}
template <class F>
SHADERTWIN_INLINE F from_bits(Unsigned<F> x) {
  return std::bit_cast<F>(x);
}
template <class F>
SHADERTWIN_INLINE F from_int(Signed<F> x) {
  if constexpr (std::is_constructible_v<F, Signed<F>>) {
    return static_cast<F>(x);
  } else {
    return __builtin_convertvector(x, F);
  }
}
template <class F>
SHADERTWIN_INLINE F magnitude_of(F x) {
  return from_bits<F>(bits(x) & 0x7fffffffU);
}

// --- float ------------------------------------------------------------------

// LLVM's fmuladd.
SHADERTWIN_INLINE float multiply_add(float a, float b, float c) {
#ifdef __FMA__
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}
SHADERTWIN_INLINE int to_int(float x) {
  return x != x ? 0 : x <= -2147483648.0F ? INT32_MIN : x >= 2147483648.0F ? INT32_MAX : static_cast<int>(x);
}
#if defined(__SSE2__)
SHADERTWIN_INLINE float first_if_less(float a, float b) {
  return _mm_cvtss_f32(_mm_min_ss(lane(a), lane(b)));
}
SHADERTWIN_INLINE float first_if_greater(float a, float b) {
  return _mm_cvtss_f32(_mm_max_ss(lane(a), lane(b)));
}
#endif

// --- double -----------------------------------------------------------------

SHADERTWIN_INLINE double multiply_add(double a, double b, double c) {
  return a * b + c;
}
SHADERTWIN_INLINE int to_int(double x) {
  return to_int(static_cast<float>(x));
}
// A value passes through float here: there are only 32 bits.
SHADERTWIN_INLINE uint bits(double x) {
  return std::bit_cast<uint>(static_cast<float>(x));
}
template <>
SHADERTWIN_INLINE double from_bits<double>(uint x) {
  return std::bit_cast<float>(x);
}

// --- Both -------------------------------------------------------------------

#define SHADERTWIN_OF_SCALARS(name, function) \
  SHADERTWIN_INLINE float name(float x) {     \
    return std::function(x);                  \
  }                                           \
  SHADERTWIN_INLINE double name(double x) {   \
    return std::function(x);                  \
  }
SHADERTWIN_OF_SCALARS(magnitude_of, fabs)
SHADERTWIN_OF_SCALARS(root, sqrt)
SHADERTWIN_OF_SCALARS(round_down, floor)
SHADERTWIN_OF_SCALARS(round_up, ceil)
SHADERTWIN_OF_SCALARS(round_to_zero, trunc)
SHADERTWIN_OF_SCALARS(round_to_even, rint)
#undef SHADERTWIN_OF_SCALARS

// What has all that the built-in functions ask for.
template <class F>
concept Number = requires(F x, Mask<F> mask, Signed<F> i, Unsigned<F> u) {
  { x + x * 2.0F - 1.0F / -x } -> std::same_as<F>;
  { x < 1.0F } -> std::same_as<Mask<F>>;
  { (x <= x) | (x > x) | (x >= x) | (x == x) | (x != x) } -> std::convertible_to<Mask<F>>;
  { constant<F>(1.0) } -> std::same_as<F>;
  { select__(mask, x, x) } -> std::same_as<F>;
  { first_if_less(x, x) } -> std::same_as<F>;
  { first_if_greater(x, x) } -> std::same_as<F>;
  { multiply_add(x, x, x) } -> std::same_as<F>;
  { magnitude_of(x) } -> std::same_as<F>;
  { root(x) } -> std::same_as<F>;
  { round_down(x) } -> std::same_as<F>;
  { round_up(x) } -> std::same_as<F>;
  { round_to_zero(x) } -> std::same_as<F>;
  { round_to_even(x) } -> std::same_as<F>;
  { to_int(x) } -> std::same_as<Signed<F>>;  // towards zero; anything where int can't hold it
  { from_int<F>(i) } -> std::same_as<F>;
  { bits(x) } -> std::same_as<Unsigned<F>>;
  { from_bits<F>(u) } -> std::same_as<F>;
};
static_assert(Number<float> && Number<double>);

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
