// Integer division and shifts, and relations, with every operand defined: C++ leaves division by zero, the
// division INT_MIN / -1 and shifts by 32 and more undefined.
#pragma once

#include "reference/glsl/number.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// --- Division: of int and uint; packets go lane by lane ---------------------

// By zero: all bits set. INT_MIN / -1 is INT_MIN.
template <class I>
SHADERTWIN_INLINE I divide_of(I a, I b) {
  constexpr bool is_signed = std::is_signed_v<I>;
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  SHADERTWIN_PROBE(is_signed && a == std::numeric_limits<I>::min() && b == I(-1), integer_division_overflow);
  if (b == 0) return I(-1);
  return is_signed && b == I(-1) ? -a : a / b;
}
// By zero: all bits set. Otherwise with the sign of a.
template <class I>
SHADERTWIN_INLINE I modulo_of(I a, I b) {
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  if (b == 0) return I(-1);
  return std::is_signed_v<I> && b == I(-1) ? I(0) : a % b;
}

// --- Shifts -----------------------------------------------------------------

// Only the lower five bits of the amount count.
template <class I, class Amount>
SHADERTWIN_INLINE I shift_left_of(I a, Amount b) {
  SHADERTWIN_PROBE(static_cast<uint>(b) > 31, shift_out_of_range);
  return a << (b & constant<Amount>(31));
}
template <class I, class Amount>
SHADERTWIN_INLINE I shift_right_of(I a, Amount b) {
  SHADERTWIN_PROBE(static_cast<uint>(b) > 31, shift_out_of_range);
  return a >> (b & constant<Amount>(31));
}

// --- Relations --------------------------------------------------------------

template <class T>
SHADERTWIN_INLINE auto lessThan_of(T a, T b) {
  return a < b;
}
template <class T>
SHADERTWIN_INLINE auto lessThanEqual_of(T a, T b) {
  return a <= b;
}
template <class T>
SHADERTWIN_INLINE auto greaterThan_of(T a, T b) {
  return a > b;
}
template <class T>
SHADERTWIN_INLINE auto greaterThanEqual_of(T a, T b) {
  return a >= b;
}
template <class T>
SHADERTWIN_INLINE auto equal_of(T a, T b) {
  return a == b;
}
template <class T>
SHADERTWIN_INLINE auto notEqual_of(T a, T b) {
  return a != b;
}

template <int N, class M>
SHADERTWIN_INLINE M any_of(const glm::vec<N, M>& v) {
  M result = v[0];
  for (int i = 1; i < N; ++i) result = result || v[i];
  return result;
}
template <int N, class M>
SHADERTWIN_INLINE M all_of(const glm::vec<N, M>& v) {
  M result = v[0];
  for (int i = 1; i < N; ++i) result = result && v[i];
  return result;
}
template <class M>
SHADERTWIN_INLINE M not__of(M x) {
  return !x;
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
