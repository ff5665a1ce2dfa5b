// GLSL's built-in functions of a Shadow (shadow.h), as far as they are more than its arithmetic: what takes a
// number to pieces is computed for each half by that half's own function, so that the double has libm's.
// What geometry.h and matrix.h make of sums and products serves as it is, and says where in it digits go.
#pragma once

#include "reference/glsl/common.h"
#include "reference/glsl/exponential.h"
#include "reference/glsl/trigonometry.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

namespace detail {

// The result of a function for each half. `step`: how high the steps of a function are that has some, else 0.
template <class Of, class... Operand>
SHADERTWIN_INLINE Shadow by_halves(const Of& of, double step, const Operand&... x) {
  const Shadow r(of(x.value...), of(x.exact...));
  if (is_plain(r)) [[likely]]
    return r;
  const bool rounded = ((static_cast<float>(x.exact) == x.value) && ...);
  const float at_rounded = rounded ? r.value : of(static_cast<float>(x.exact)...);
  Settled how;
  how.own = error_of(at_rounded, r.exact);
  double worst = -1.0;  // of the operands
  const auto compare = [&](const Shadow& operand) {
    const double share = share_of(error_of(operand), operand);
    if (share <= worst) return;
    worst = share;
    how.origin = operand.origin;
  };
  (compare(x), ...);
  const double error = error_of(r);
  how.arriving = how.own < error ? error - how.own : 0.0;
  const double itself = error_of(at_rounded, of(static_cast<double>(static_cast<float>(x.exact))...));
  how.loss = 2.0 * itself >= how.own ? Loss::coarse : Loss::conditioning;
  // Numbers that are hardly apart part here; others have lost their digits before.
  if (step > 0.0 && 2.0 * error >= step && worst < 0x1p-10) {
    how.loss = Loss::jump;
    how.own = error;
  }
  return settled(how, {x...}, r);
}

// One of two operands for each half.
SHADERTWIN_INLINE Shadow chosen(Shadow r, const Shadow& a, const Shadow& b) {
  if ((a.origin | b.origin) != 0)
    r.origin = r.value == a.value && r.exact == a.exact   ? a.origin
               : r.value == b.value && r.exact == b.exact ? b.origin
               : error_of(a) >= error_of(b)               ? a.origin
                                                          : b.origin;
  return r;
}

}  // namespace detail

// --- What number.h asks for -------------------------------------------------

SHADERTWIN_INLINE Shadow magnitude_of(Shadow x) {
  return {std::fabs(x.value), std::fabs(x.exact), x.origin};
}
SHADERTWIN_OUTLINE inline Shadow root(Shadow x) {
  return detail::by_halves([](auto v) { return detail::root(v); }, 0.0, x);
}
#define SHADERTWIN_ROUNDING(f)                                             \
  SHADERTWIN_OUTLINE inline Shadow f(Shadow x) {                           \
    return detail::by_halves([](auto v) { return detail::f(v); }, 1.0, x); \
  }
SHADERTWIN_ROUNDING(round_down)
SHADERTWIN_ROUNDING(round_up)
SHADERTWIN_ROUNDING(round_to_zero)
SHADERTWIN_ROUNDING(round_to_even)
#undef SHADERTWIN_ROUNDING
SHADERTWIN_INLINE Shadow first_if_less(Shadow a, Shadow b) {
  return detail::chosen({detail::first_if_less(a.value, b.value), detail::first_if_less(a.exact, b.exact)}, a,
                        b);
}
SHADERTWIN_INLINE Shadow first_if_greater(Shadow a, Shadow b) {
  return detail::chosen(
      {detail::first_if_greater(a.value, b.value), detail::first_if_greater(a.exact, b.exact)}, a, b);
}
SHADERTWIN_INLINE Shadow multiply_add(Shadow a, Shadow b, Shadow c) {
  return {detail::multiply_add(a.value, b.value, c.value), a.exact * b.exact + c.exact};
}
SHADERTWIN_INLINE int to_int(Shadow x) {
  const int of_float = detail::to_int(x.value);
  const int of_double = detail::to_int(x.exact);
  return of_float == of_double ? of_float : parted__(of_float, of_double, x);
}
SHADERTWIN_INLINE std::uint32_t bits(Shadow x) {
  const std::uint32_t of_float = detail::bits(x.value);
  const std::uint32_t of_double = detail::bits(x.exact);
  return of_float == of_double ? of_float : parted_bits__(of_float, of_double, x);
}

namespace detail {

template <>
SHADERTWIN_INLINE Shadow from_bits<Shadow>(uint x) {
  return std::bit_cast<float>(x);
}

// --- By halves --------------------------------------------------------------

#define SHADERTWIN_OF_1(f, step)                                 \
  SHADERTWIN_OUTLINE inline Shadow f##_of(Shadow x) {            \
    return by_halves([](auto v) { return f##_of(v); }, step, x); \
  }
#define SHADERTWIN_OF_2(f, step)                                               \
  SHADERTWIN_OUTLINE inline Shadow f##_of(Shadow x, Shadow y) {                \
    return by_halves([](auto v, auto w) { return f##_of(v, w); }, step, x, y); \
  }
SHADERTWIN_OF_1(sin, 0.0)
SHADERTWIN_OF_1(cos, 0.0)
SHADERTWIN_OF_1(tan, 0.0)
SHADERTWIN_OF_1(asin, 0.0)
SHADERTWIN_OF_1(acos, 0.0)
SHADERTWIN_OF_1(atan, 0.0)
SHADERTWIN_OF_2(atan, 0.0)
SHADERTWIN_OF_1(atan_strict, 0.0)
SHADERTWIN_OF_2(atan_strict, 0.0)
SHADERTWIN_OF_1(sinh, 0.0)
SHADERTWIN_OF_1(cosh, 0.0)
SHADERTWIN_OF_1(tanh, 0.0)
SHADERTWIN_OF_1(asinh, 0.0)
SHADERTWIN_OF_1(acosh, 0.0)
SHADERTWIN_OF_1(atanh, 0.0)
SHADERTWIN_OF_2(pow, 0.0)
SHADERTWIN_OF_1(exp, 0.0)
SHADERTWIN_OF_1(log, 0.0)
SHADERTWIN_OF_1(exp2, 0.0)
SHADERTWIN_OF_1(log2, 0.0)
SHADERTWIN_OF_1(sign, 1.0)
SHADERTWIN_OF_1(fract, 1.0)
SHADERTWIN_OF_2(mod, std::fabs(y.exact))
SHADERTWIN_OF_2(step, 1.0)
#undef SHADERTWIN_OF_1
#undef SHADERTWIN_OF_2
SHADERTWIN_OUTLINE inline Shadow smoothstep_of(Shadow edge0, Shadow edge1, Shadow x) {
  return by_halves([](auto a, auto b, auto v) { return smoothstep_of(a, b, v); }, 0.0, edge0, edge1, x);
}
SHADERTWIN_INLINE Shadow min_of(Shadow a, Shadow b) {
  return chosen({min_of(a.value, b.value), min_of(a.exact, b.exact)}, a, b);
}
SHADERTWIN_INLINE Shadow max_of(Shadow a, Shadow b) {
  return chosen({max_of(a.value, b.value), max_of(a.exact, b.exact)}, a, b);
}
SHADERTWIN_INLINE Shadow clamp_of(Shadow x, Shadow low, Shadow high) {
  return min_of(max_of(x, low), high);
}

}  // namespace detail
}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
