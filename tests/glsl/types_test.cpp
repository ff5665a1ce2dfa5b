// GLSL's rules for types, which C++ and GLM do not share.
#include <gtest/gtest.h>

#include <cmath>

#include <climits>

#include "reference/glsl/glsl.h"

namespace shadertwin::glsl {
namespace {

TEST(Negation, KeepsTheSignOfAZero) {
  const vec4 negated = -vec4(0, 1, -2, 0);
  EXPECT_TRUE(std::signbit(negated.x));
  EXPECT_TRUE(std::signbit(negated.w));
  EXPECT_EQ(negated.z, Float(2));
}

TEST(Array, ClampsItsIndex) {
  array<float, 3> a{{1.0F, 2.0F, 3.0F}};
  EXPECT_EQ(a[-1], 1.0F);
  EXPECT_EQ(a[3], 3.0F);
  EXPECT_EQ(a[INT_MIN], 1.0F);
  EXPECT_EQ(a[0xffffffffU], 3.0F);
  EXPECT_EQ(a.length(), 3);
}

TEST(Array, IsAValue) {
  array<vec2, 2> a{{vec2(1, 2), vec2(3, 4)}};
  array<vec2, 2> b = a;
  EXPECT_TRUE(a == b);
  b[1].y = 5;
  EXPECT_FALSE(a == b);
  EXPECT_EQ(a[1].y, 4);
}

TEST(Array, OfNaNDiffersFromItself) {
  const array<float, 1> a{{detail::nan}};
  EXPECT_FALSE(a == a);
}

TEST(Swizzle, AssignsItsOwnComponentsWithoutOverlap) {
  vec3 v(1, 2, 3);
  swizzle<0, 1>(v) = v.yx();
  EXPECT_EQ(v, vec3(2, 1, 3));
  swizzle<2, 0>(v) = swizzle<0, 2>(v);
  EXPECT_EQ(v, vec3(3, 1, 2));
}

TEST(Swizzle, TakesCompoundAssignments) {
  vec4 v(1, 2, 3, 4);
  swizzle<3, 1>(v) += vec2(10, 20);
  swizzle<0, 2>(v) *= 2.0F;
  EXPECT_EQ(v, vec4(2, 22, 6, 14));
}

TEST(DynamicIndex, ReachesComponentsAndColumns) {
  vec3 v(1, 2, 3);
  at(v, 7) = 9;
  EXPECT_EQ(v.z, 9);
  mat2 m(1, 2, 3, 4);
  at(at(m, 1U), -3) = 8;
  EXPECT_EQ(m, mat2(1, 2, 8, 4));
}

TEST(Make, ConvertsEveryComponent) {
  EXPECT_EQ(make<ivec3>(vec2(-1.75F, 2.5F), true), ivec3(-1, 2, 1));
  EXPECT_EQ(make<bvec2>(vec2(0.0F, 0.25F)), bvec2(false, true));
  EXPECT_EQ(make<vec3>(3), vec3(3));
  EXPECT_EQ(make<Float>(uvec2(7, 8)), 7);
}

TEST(Make, DropsSurplusComponents) {
  EXPECT_EQ(make<vec2>(vec4(1, 2, 3, 4)), vec2(1, 2));
}

TEST(Make, BuildsMatrices) {
  EXPECT_EQ(make<mat2>(3), mat2(3, 0, 0, 3));
  EXPECT_EQ(make<mat3>(mat2(1, 2, 3, 4)), mat3(1, 2, 0, 3, 4, 0, 0, 0, 1));
  EXPECT_EQ(make<mat2>(mat4x3(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)), mat2(1, 2, 4, 5));
  EXPECT_EQ(make<mat2x3>(vec4(1, 2, 3, 4), 5, true), mat2x3(1, 2, 3, 4, 5, 1));
  EXPECT_EQ(make<vec4>(mat2(1, 2, 3, 4)), vec4(1, 2, 3, 4));
}

TEST(IntegerDivision, IsDefinedEverywhere) {
  EXPECT_EQ(divide(7, 0), -1);
  EXPECT_EQ(divide(7U, 0U), 0xffffffffU);
  EXPECT_EQ(divide(INT_MIN, -1), INT_MIN);
  EXPECT_EQ(modulo(INT_MIN, -1), 0);
  EXPECT_EQ(modulo(7, 0), -1);
  EXPECT_EQ(divide(ivec2(7, -7), 2), ivec2(3, -3));
}

TEST(Shift, CountsFiveBits) {
  EXPECT_EQ(shift_left(1, 33), 2);
  EXPECT_EQ(shift_right(-8, 1U), -4);
  EXPECT_EQ(shift_right(0x80000000U, -1), 1U);
  EXPECT_EQ(shift_left(uvec2(1, 2), 4), uvec2(16, 32));
}

TEST(Matrix, DividesByComponents) {
  EXPECT_EQ(mat2(2, 4, 6, 8) / mat2(1, 2, 3, 4), mat2(2, 2, 2, 2));
}

TEST(Matrix, MultipliesColumnsByRows) {
  const mat3x2 a(1, 2, 3, 4, 5, 6);
  const mat2x3 b(1, 2, 3, 4, 5, 6);
  EXPECT_EQ(a * b, mat2(22, 28, 49, 64));
  EXPECT_EQ(a * vec3(1, 2, 3), vec2(22, 28));
  EXPECT_EQ(vec2(1, 2) * a, vec3(5, 11, 17));
}

}  // namespace
}  // namespace shadertwin::glsl
