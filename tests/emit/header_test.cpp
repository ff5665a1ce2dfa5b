// A shader's functions as a C++ header.
#include <gtest/gtest.h>

#include "functions.h"

namespace {

TEST(Header, FunctionsAreCalledByTheirNames) {
  EXPECT_FLOAT_EQ(functions::schlick(0.5f, 1.5f), 0.04f + 0.96f / 32.0f);
  EXPECT_EQ(functions::schlick(0.0f, 1.5f), 1.0f);
}

TEST(Header, StructuresAndReferencesAreCpps) {
  float t = 0;
  const functions::Sphere sphere{functions::vec3(0, 0, -3), 1};
  EXPECT_TRUE(functions::hit(sphere, functions::vec3(0), functions::vec3(0, 0, -1), t));
  EXPECT_EQ(t, 2.0f);
  EXPECT_FALSE(functions::hit(sphere, functions::vec3(0), functions::vec3(0, 1, 0), t));
}

TEST(Header, GlobalsBelongToTheThreadAndCanBeSet) {
  functions::seed = 1;
  const unsigned first = functions::random();
  EXPECT_EQ(first, 747796405U + 2891336453U);
  EXPECT_NE(functions::random(), first);
  functions::seed = 1;
  EXPECT_EQ(functions::random(), first);
  functions::iTime = 2.0f;
  EXPECT_EQ(functions::in_time(1.5f), 3.0f);
}

TEST(Header, UninitialisedVariablesAreZero) {
  EXPECT_EQ(functions::blurred({{4.0f, 2.0f, 4.0f}}), 3.0f);
}

TEST(Header, BuiltinsAreNotMixedUpWithTheCLibrarys) {
  EXPECT_EQ(functions::with_library_names(-4.0f), 4.0f + 2.0f - 4.0f + 64.0f - 4.0f);
}

TEST(Header, DiscardThrows) {
  EXPECT_THROW(functions::in_time(-1.0f), shadertwin::glsl::Discarded);
}

}  // namespace
