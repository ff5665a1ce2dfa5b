// Every kind of the catalogue of undefined GLSL is reported where it happens, and nowhere else.
#include <gtest/gtest.h>

#include <climits>
#include <vector>

#include "reference/glsl/glsl.h"

namespace shadertwin::glsl {

namespace {
std::vector<Check> reports;
}

void report(Check kind) {
  reports.push_back(kind);
}

namespace {

template <class Call>
std::vector<Check> reported(Call call) {
  reports.clear();
  [[maybe_unused]] const volatile bool kept = (call(), true);
  return reports;
}

#define EXPECT_REPORT(kind, expression) \
  EXPECT_EQ(reported([] { return expression; }), std::vector<Check>{Check::kind}) << #expression
#define EXPECT_SILENCE(expression) \
  EXPECT_EQ(reported([] { return expression; }), std::vector<Check>{}) << #expression

TEST(Probes, ReportEveryUndefinedUse) {
  EXPECT_REPORT(pow_negative_base, pow(Float(-1), Float(2)));
  EXPECT_REPORT(pow_zero_base, pow(Float(0), Float(0)));
  EXPECT_REPORT(sqrt_negative, sqrt(vec2(4, -1)));
  EXPECT_REPORT(inversesqrt_not_positive, inversesqrt(Float(0)));
  EXPECT_REPORT(log_not_positive, log(vec3(1, 0, 1)));
  EXPECT_REPORT(log_not_positive, log2(Float(-2)));
  EXPECT_REPORT(asin_beyond_one, asin(Float(1.5)));
  EXPECT_REPORT(acos_beyond_one, acos(Float(-1.5)));
  EXPECT_REPORT(acosh_below_one, acosh(Float(0.5)));
  EXPECT_REPORT(atanh_beyond_one, atanh(Float(1)));
  EXPECT_REPORT(atan_of_zeros, atan(Float(0), Float(0)));
  EXPECT_REPORT(mod_by_zero, mod(Float(1), Float(0)));
  EXPECT_REPORT(clamp_crossed, clamp(Float(0), Float(1), Float(0)));
  EXPECT_REPORT(clamp_crossed, clamp(3, 2, 1));
  EXPECT_REPORT(smoothstep_crossed, smoothstep(Float(1), Float(1), Float(0)));
  EXPECT_REPORT(normalize_zero, normalize(vec3(0)));
  EXPECT_REPORT(float_division_by_zero, checked_divide(vec2(1), vec2(1, 0)));
  EXPECT_REPORT(integer_division_by_zero, divide(1, 0));
  EXPECT_REPORT(integer_division_by_zero, modulo(1U, 0U));
  EXPECT_REPORT(integer_division_overflow, divide(INT_MIN, -1));
  EXPECT_REPORT(shift_out_of_range, shift_left(1, 32));
  EXPECT_REPORT(shift_out_of_range, shift_right(1U, -1));
  EXPECT_REPORT(index_out_of_bounds, (array<Float, 2>{{1, 2}}[2]));
  EXPECT_REPORT(index_out_of_bounds, at(vec3(1), -1));
  EXPECT_REPORT(conversion_out_of_range, make<int>(Float(3e9)));
  EXPECT_REPORT(conversion_out_of_range, make<uvec2>(vec2(1, -2)));
  EXPECT_REPORT(inverse_of_singular, inverse(mat3(0)));
}

TEST(Probes, AreSilentInsideEveryDomain) {
  EXPECT_SILENCE(pow(Float(2), Float(-3)));
  EXPECT_SILENCE(sqrt(Float(0)));
  EXPECT_SILENCE(inversesqrt(Float(1e-30)));
  EXPECT_SILENCE(log(vec4(1e-30)));
  EXPECT_SILENCE(asin(vec2(-1, 1)));
  EXPECT_SILENCE(acos(vec2(-1, 1)));
  EXPECT_SILENCE(acosh(Float(1)));
  EXPECT_SILENCE(atan(Float(0), Float(-1)));
  EXPECT_SILENCE(mod(vec2(1), Float(-2)));
  EXPECT_SILENCE(clamp(vec3(7), Float(1), Float(1)));
  EXPECT_SILENCE(smoothstep(Float(0), Float(1), vec2(9)));
  EXPECT_SILENCE(normalize(vec2(1e-10, 0)));
  EXPECT_SILENCE(checked_divide(mat2(1), Float(2)));
  EXPECT_SILENCE(divide(ivec2(INT_MIN), 2));
  EXPECT_SILENCE(shift_left(uvec2(1), 31));
  EXPECT_SILENCE((array<Float, 2>{{1, 2}}[1U]));
  EXPECT_SILENCE(make<ivec2>(vec2(-2147483648.0, 2147483520.0)));
  EXPECT_SILENCE(inverse(mat4(2)));
}

TEST(Probes, DescribeEveryKind) {
  for (int kind = 0; kind < static_cast<int>(Check::count); ++kind) {
    EXPECT_STRNE(describe(static_cast<Check>(kind)), "");
  }
}

}  // namespace
}  // namespace shadertwin::glsl
