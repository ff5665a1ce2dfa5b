// A float with the double beside it that the same operations would give: the number type of the twin that
// `accuracy` runs. The float half has the float twin's bits. The double half is computed from doubles alone,
// along the float's control flow, as the twin in double computes it.
//
// Each number also knows its origin: the operation from which most of its error comes. After Herbgrind
// (Sanchez-Stern et al., PLDI 2018), an operation's own error is what it makes of operands that are exact but
// for their rounding to float; that tells a loss which is born here from one that arrives with the operands.
// An operation is the origin of its result's error if its own is at least half of that; otherwise the operand
// is that contributes most. One origin a number, and not a set of them, is what keeps it cheap.
//
// Only errors above `notable` are looked at more closely, out of line.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "reference/glsl/loss.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

struct Shadow {
  float value;
  std::uint32_t origin;  // 0: none
  double exact;

  Shadow() = default;
  constexpr Shadow(float x) : value(x), origin(0), exact(x) {}
  explicit constexpr Shadow(double x) : value(static_cast<float>(x)), origin(0), exact(x) {}
  explicit constexpr Shadow(int x) : value(static_cast<float>(x)), origin(0), exact(x) {}
  explicit constexpr Shadow(std::uint32_t x) : value(static_cast<float>(x)), origin(0), exact(x) {}
  constexpr Shadow(float v, double e, std::uint32_t o = 0) : value(v), origin(o), exact(e) {}
  explicit constexpr operator float() const { return value; }
  explicit constexpr operator double() const { return exact; }
};

// --- What the program that runs a twin defines (twin/shadows.h) -------------

// An operation loses `own` of its result, relative to it. Gives the operation as an origin.
std::uint32_t lost__(Loss loss, const Shadow* operands, int count, const Shadow& result, double own);
// A comparison comes out differently for the two halves. Gives the outcome that counts.
bool parted__(bool of_float, const Shadow& a, const Shadow& b);
// A number becomes two different integers.
int parted__(int of_float, int of_double, const Shadow& x);
std::uint32_t parted__(std::uint32_t of_float, std::uint32_t of_double, const Shadow& x);
// The bits of a number are read, and those of its double, rounded, are others: any error does that.
std::uint32_t parted_bits__(std::uint32_t of_float, std::uint32_t of_double, const Shadow& x);
// Whether one pixel is told operation by operation, and the telling of a result with a notable error. `own`:
// what lost__ has got for it, else 0.
inline bool telling__ = false;
void tell__(const Shadow* operands, int count, const Shadow& result, double own);

// --- Errors -----------------------------------------------------------------

constexpr double notable = 0x1p-18;

inline double larger_of(double a, double b) {
  return a > b ? a : b;
}

inline double distance_of(float value, double exact) {
  return std::fabs(static_cast<double>(value) - exact);
}
inline double distance_of(const Shadow& x) {
  return distance_of(x.value, x.exact);
}
// The absolute value of the half that is farther from 0.
inline double larger_half_of(const Shadow& x) {
  return larger_of(std::fabs(static_cast<double>(x.value)), std::fabs(x.exact));
}

// How far the float is from the exact number: 0 for two NaNs, infinite if just one is.
inline double error_of(float value, double exact) {
  const double error = distance_of(value, exact);
  if (error == error) return error;
  return value == exact || (value != value && exact != exact) ? 0.0 : std::numeric_limits<double>::infinity();
}
inline double error_of(const Shadow& x) {
  return error_of(x.value, x.exact);
}

// Part of a result, at most all of it; infinite where one of the two is no number.
inline double share_of(double error, const Shadow& result) {
  if (error == 0.0 || error == std::numeric_limits<double>::infinity()) return error;
  const double size = larger_half_of(result);
  return error < size ? error / size : 1.0;
}

// What an operation says of its result when there is more than rounding to it.
struct Settled {
  double own = 0.0;            // the operation's error for operands that are exact but for rounding
  double arriving = 0.0;       // the largest part of the error that one operand brings
  std::uint32_t origin = 0;    // of that operand
  Loss loss = Loss::rounding;  // if `own` is notable
  Loss slow = Loss::rounding;  // if it is not, and nor is that of any operation before
};

// Whether a float holds the exact number but for rounding.
inline bool fits_float(const Shadow& x) {
  return !(distance_of(static_cast<float>(x.exact), x.exact) > notable * std::fabs(x.exact));
}

template <int count>
double worst_share(const Shadow (&operands)[count]) {
  double worst = 0.0;
  for (const Shadow& operand : operands) worst = larger_of(worst, share_of(error_of(operand), operand));
  return worst;
}

template <int count>
[[gnu::noinline]] Shadow settled(const Settled& how, const Shadow (&operands)[count], Shadow result) {
  const double error = error_of(result);
  if (!(share_of(error, result) > notable)) return result;
  double own = share_of(how.own, result);
  // An operand that no float holds was lost where it was made.
  if (how.origin != 0)
    for (const Shadow& operand : operands)
      if (!fits_float(operand)) own = 0.0;
  result.origin = how.origin;
  if (own > notable) {
    const std::uint32_t here = lost__(how.loss, operands, count, result, own);
    // Also what magnifies no more than the roundings of several operations.
    const bool of_roundings = 8.0 * how.own >= error && worst_share(operands) < 0x1p-16;
    if (how.origin == 0 || 2.0 * how.own >= error || of_roundings) result.origin = here;
  } else if (how.origin == 0) {
    result.origin = lost__(how.slow, operands, count, result, own);
  }
  if (telling__) [[unlikely]]
    tell__(operands, count, result, own > notable ? own : 0.0);
  return result;
}

// The usual case: an error of a few roundings. What has an origin loses it here: if such an error is
// magnified later, that is where digits go.
[[gnu::always_inline]] inline bool is_plain(const Shadow& result) {
  return distance_of(result) <= std::fabs(result.exact) * notable;
}

// --- Arithmetic -------------------------------------------------------------

// Most errors that are notable have only arrived: the operation adds little, and the larger one of its
// operands' errors, `of_a` or `of_b`, has an origin. Then gives the result this origin. False, and nothing
// done, where there is more to tell, or anything is infinite or no number.
[[gnu::always_inline]] inline bool passes_on(double own, double of_a, double of_b, const Shadow& a,
                                             const Shadow& b, Shadow& result) {
  const double small = notable * larger_half_of(result);
  if (!(own <= small) || !(small + of_a + of_b < std::numeric_limits<double>::infinity()) || telling__)
    return false;
  if (distance_of(result) <= small) return true;
  const std::uint32_t origin = of_a >= of_b ? a.origin : b.origin;
  if (origin == 0) return false;
  result.origin = origin;
  return true;
}

// `sum` is rounded(a) + rounded(b). Operands by value: in registers, where their addresses would keep them in
// memory.
[[gnu::noinline]] inline Shadow settled_sum(Shadow a, Shadow b, float sum, Shadow result) {
  if (passes_on(distance_of(sum, result.exact), distance_of(a), distance_of(b), a, b, result)) [[likely]]
    return result;
  const double of_a = error_of(a);
  const double of_b = error_of(b);
  Settled how{error_of(sum, result.exact), larger_of(of_a, of_b), of_a >= of_b ? a.origin : b.origin,
              Loss::cancellation};
  if (std::isinf(sum) && !std::isinf(result.exact)) how.loss = Loss::overflow;
  // What is left of equal numbers is the doubles' own rounding.
  const double larger = larger_of(std::fabs(a.exact), std::fabs(b.exact));
  if (sum == 0.0F && std::fabs(result.exact) <= 0x1p-45 * larger) how.own = 0.0;
  const double smaller = std::fabs(a.exact) < std::fabs(b.exact) ? std::fabs(a.exact) : std::fabs(b.exact);
  if (smaller > 0.0 && 8.0 * how.own >= smaller) how.slow = Loss::absorption;
  return settled(how, {a, b}, result);
}

// `product` is rounded(a) * rounded(b) or the quotient: relative errors add up.
[[gnu::noinline]] inline Shadow settled_product(Shadow a, Shadow b, float product, Shadow result) {
  const double size_a = larger_half_of(a);
  const double size_b = larger_half_of(b);
  const auto part = [](double error, double size) { return error < size ? error : size; };
  if (passes_on(distance_of(product, result.exact), part(distance_of(a), size_a) * size_b,
                part(distance_of(b), size_b) * size_a, a, b, result)) [[likely]]
    return result;
  const double of_a = share_of(error_of(a), a);
  const double of_b = share_of(error_of(b), b);
  Settled how{error_of(product, result.exact), larger_of(of_a, of_b) * std::fabs(result.exact),
              of_a >= of_b ? a.origin : b.origin};
  if (how.arriving != how.arriving) how.arriving = 0.0;
  how.loss = std::fabs(product) < std::numeric_limits<float>::min() ? Loss::underflow : Loss::overflow;
  return settled(how, {a, b}, result);
}

[[gnu::always_inline]] inline Shadow operator+(const Shadow& a, const Shadow& b) {
  const Shadow r(a.value + b.value, a.exact + b.exact);
  if (is_plain(r)) [[likely]]
    return r;
  return settled_sum(a, b, static_cast<float>(a.exact) + static_cast<float>(b.exact), r);
}
[[gnu::always_inline]] inline Shadow operator-(const Shadow& a, const Shadow& b) {
  const Shadow r(a.value - b.value, a.exact - b.exact);
  if (is_plain(r)) [[likely]]
    return r;
  return settled_sum(a, b, static_cast<float>(a.exact) - static_cast<float>(b.exact), r);
}
[[gnu::always_inline]] inline Shadow operator*(const Shadow& a, const Shadow& b) {
  const Shadow r(a.value * b.value, a.exact * b.exact);
  if (is_plain(r)) [[likely]]
    return r;
  return settled_product(a, b, static_cast<float>(a.exact) * static_cast<float>(b.exact), r);
}
[[gnu::always_inline]] inline Shadow operator/(const Shadow& a, const Shadow& b) {
  const Shadow r(a.value / b.value, a.exact / b.exact);
  if (is_plain(r)) [[likely]]
    return r;
  return settled_product(a, b, static_cast<float>(a.exact) / static_cast<float>(b.exact), r);
}
[[gnu::always_inline]] inline Shadow operator-(const Shadow& a) {
  return Shadow(-a.value, -a.exact, a.origin);
}
[[gnu::always_inline]] inline Shadow operator+(const Shadow& a) {
  return a;
}
// GLM's vectors compute with these.
[[gnu::always_inline]] inline Shadow& operator+=(Shadow& a, const Shadow& b) {
  return a = a + b;
}
[[gnu::always_inline]] inline Shadow& operator-=(Shadow& a, const Shadow& b) {
  return a = a - b;
}
[[gnu::always_inline]] inline Shadow& operator*=(Shadow& a, const Shadow& b) {
  return a = a * b;
}
[[gnu::always_inline]] inline Shadow& operator/=(Shadow& a, const Shadow& b) {
  return a = a / b;
}
inline Shadow& operator++(Shadow& a) {
  return a = a + 1.0F;
}
inline Shadow& operator--(Shadow& a) {
  return a = a - 1.0F;
}
inline Shadow operator++(Shadow& a, int) {
  const Shadow before = a;
  ++a;
  return before;
}
inline Shadow operator--(Shadow& a, int) {
  const Shadow before = a;
  --a;
  return before;
}

// --- Comparisons ------------------------------------------------------------

#define SHADERTWIN_COMPARISON(op)                                                    \
  [[gnu::always_inline]] inline bool operator op(const Shadow& a, const Shadow& b) { \
    const bool of_float = a.value op b.value;                                        \
    if (of_float != (a.exact op b.exact)) [[unlikely]]                               \
      return parted__(of_float, a, b);                                               \
    return of_float;                                                                 \
  }
SHADERTWIN_COMPARISON(<)
SHADERTWIN_COMPARISON(>)
SHADERTWIN_COMPARISON(<=)
SHADERTWIN_COMPARISON(>=)
SHADERTWIN_COMPARISON(==)
SHADERTWIN_COMPARISON(!=)
#undef SHADERTWIN_COMPARISON

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
