// The built-ins with Float widened to double.
#define SHADERTWIN_DOUBLE
#include <gtest/gtest.h>

#include <cmath>

#include "reference/glsl/glsl.h"

namespace shadertwin::glsl {
namespace {

static_assert(std::is_same_v<Float, double> && std::is_same_v<vec3::value_type, double> &&
              std::is_same_v<mat4::value_type, double>);

TEST(Doubles, KeepTheirPrecision) {
  EXPECT_EQ(sin(0.1), std::sin(0.1));
  EXPECT_EQ(exp(vec2(1e-9)).y, std::exp(1e-9));
  EXPECT_EQ(length(vec3(1e-9, 0, 0)), 1e-9);
  EXPECT_EQ((mat2(1.0 / 3.0) * vec2(1)).x, 1.0 / 3.0);
  EXPECT_EQ(make<vec2>(1, 0.1).y, 0.1);
}

// Where GLSL leaves a result open, as the float built-ins have it.
TEST(Doubles, HaveTheDomainsOfFloats) {
  EXPECT_TRUE(isnan(pow(-2.0, 2.0)));
  EXPECT_EQ(pow(0.0, 0.0), 1.0);
  EXPECT_EQ(pow(0.0, -1.0), detail::infinity);
  EXPECT_EQ(mod(1.5, 0.0), 1.5);
  EXPECT_EQ(atan(0.0, -0.0), 0.0);
  EXPECT_EQ(make<int>(3e9), 2147483647);
  EXPECT_EQ(make<uint>(-4.5), 0U);
  EXPECT_EQ(max(detail::nan, 0.0), 0.0);
  EXPECT_EQ(min(1.0, detail::nan), 1.0);
  EXPECT_EQ(clamp(detail::nan, 2.0, 3.0), 2.0);
  EXPECT_EQ(sign(detail::nan), 0.0);
  EXPECT_EQ(log(0.0), -detail::infinity);
  EXPECT_TRUE(isnan(asin(1.5)));
  EXPECT_EQ(roundEven(2.5), 2.0);
  EXPECT_EQ(round(-0.5), 0.0);
  EXPECT_EQ(refract(vec3(1, 0, 0), vec3(0, 1, 0), 1.5), vec3(0));
}

TEST(Doubles, ShareTheirBitsWithFloats) {
  EXPECT_EQ(floatBitsToUint(1.0), 0x3f800000U);
  EXPECT_EQ(uintBitsToFloat(0x3dcccccdU), static_cast<double>(0.1F));
  EXPECT_EQ(packHalf2x16(vec2(1, -2)), 0xc0003c00U);
}

}  // namespace
}  // namespace shadertwin::glsl
