// The catalogue of undefined GLSL that `check` looks for at run time. A twin compiled with SHADERTWIN_CHECK
// calls report() at each undefined use; any other twin has no trace of it.
#pragma once

namespace shadertwin::glsl {

enum class Check : int {
  pow_negative_base,
  pow_zero_base,  // pow(0, y) with y <= 0
  sqrt_negative,
  inversesqrt_not_positive,
  log_not_positive,
  asin_beyond_one,
  acos_beyond_one,
  acosh_below_one,
  atanh_beyond_one,
  atan_of_zeros,
  mod_by_zero,
  clamp_crossed,       // clamp(x, lo, hi) with lo > hi
  smoothstep_crossed,  // smoothstep(e0, e1, x) with e0 >= e1
  normalize_zero,
  float_division_by_zero,
  integer_division_by_zero,
  integer_division_overflow,  // INT_MIN / -1
  shift_out_of_range,
  index_out_of_bounds,
  conversion_out_of_range,  // float to int or uint
  inverse_of_singular,
  first_nan,
  first_infinity,
  loop_beyond_cap,
  count
};

// What a person is told, e.g. "pow() of a negative base".
constexpr const char* describe(Check kind) {
  switch (kind) {
    case Check::pow_negative_base:
      return "pow() of a negative base";
    case Check::pow_zero_base:
      return "pow() of zero with an exponent that is not positive";
    case Check::sqrt_negative:
      return "sqrt() of a negative number";
    case Check::inversesqrt_not_positive:
      return "inversesqrt() of zero or a negative number";
    case Check::log_not_positive:
      return "log() or log2() of zero or a negative number";
    case Check::asin_beyond_one:
      return "asin() of a number beyond 1";
    case Check::acos_beyond_one:
      return "acos() of a number beyond 1";
    case Check::acosh_below_one:
      return "acosh() of a number below 1";
    case Check::atanh_beyond_one:
      return "atanh() of a number that is not inside (-1, 1)";
    case Check::atan_of_zeros:
      return "atan(0, 0)";
    case Check::mod_by_zero:
      return "mod() by zero";
    case Check::clamp_crossed:
      return "clamp() with a lower bound above the upper one";
    case Check::smoothstep_crossed:
      return "smoothstep() with a first edge that is not below the second";
    case Check::normalize_zero:
      return "normalize() of a vector of length zero";
    case Check::float_division_by_zero:
      return "division by zero";
    case Check::integer_division_by_zero:
      return "integer division by zero";
    case Check::integer_division_overflow:
      return "integer division that overflows";
    case Check::shift_out_of_range:
      return "shift by a negative number or by 32 and more";
    case Check::index_out_of_bounds:
      return "index out of bounds";
    case Check::conversion_out_of_range:
      return "float that the integer type can't hold";
    case Check::inverse_of_singular:
      return "inverse() of a singular matrix";
    case Check::first_nan:
      return "NaN first appears";
    case Check::first_infinity:
      return "infinity first appears";
    case Check::loop_beyond_cap:
      return "loops of more than 65534 rounds in all: llvmpipe stops them there";
    case Check::count:
      break;
  }
  return "";
}

#ifdef SHADERTWIN_CHECK
// Defined by whoever runs the twin. Called on the thread of the invocation, once for each undefined use.
void report(Check kind);
#endif

}  // namespace shadertwin::glsl

#ifdef SHADERTWIN_CHECK
#define SHADERTWIN_PROBE(condition, kind)                          \
  do {                                                             \
    if (condition) [[unlikely]]                                    \
      ::shadertwin::glsl::report(::shadertwin::glsl::Check::kind); \
  } while (false)
#else
#define SHADERTWIN_PROBE(condition, kind) static_cast<void>(0)
#endif
