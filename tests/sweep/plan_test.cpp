#include "host/sweep/plan.h"

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace shadertwin::sweep {
namespace {

using Values = std::vector<std::string>;

TEST(SplitValues, CommasWithinBracketsSeparateNothing) {
  EXPECT_EQ(split_values("1"), Values({"1"}));
  EXPECT_EQ(split_values("0.5,vec2(1,2),a[3]"), Values({"0.5", "vec2(1,2)", "a[3]"}));
}

TEST(SplitValues, RefusesNothingAndTheSameTwice) {
  EXPECT_THROW(split_values("1,,2"), Error);
  EXPECT_THROW(split_values("1,2,"), Error);
  EXPECT_THROW(split_values("1,2,1"), Error);
}

const std::vector<Axis> axes = {{Axis::Kind::define, "SCENE", {"0", "1"}, true},
                                {Axis::Kind::define, "STEPS", {"8", "16", "32"}, false},
                                {Axis::Kind::on, "on", {"cpu", "llvmpipe"}, false}};

TEST(Points, OfAProductAreAllCombinations) {
  const std::vector<Point> points = all_combinations(axes);
  ASSERT_EQ(points.size(), 12U);
  EXPECT_EQ(points.front(), Point({"0", "8", "cpu"}));
  EXPECT_EQ(points[1], Point({"0", "8", "llvmpipe"}));
  EXPECT_EQ(points.back(), Point({"1", "32", "llvmpipe"}));
}

TEST(Points, OneAtATimeDifferFromTheBaseInOneAxis) {
  const std::vector<Point> points = one_at_a_time(axes, {"0", "64", "cpu"});
  ASSERT_EQ(points.size(), 2U * (1 + 3 + 1));
  EXPECT_EQ(points[0], Point({"0", "64", "cpu"}));
  EXPECT_EQ(points[1], Point({"0", "8", "cpu"}));
  EXPECT_EQ(points[4], Point({"0", "64", "llvmpipe"}));
  EXPECT_EQ(points[5], Point({"1", "64", "cpu"}));
  // The base is there once, also if the axis names its value.
  EXPECT_EQ(one_at_a_time(axes, {"0", "8", "cpu"}).size(), 2U * (1 + 2 + 1));
}

TEST(Labels, NameWhatVaries) {
  const std::vector<Axis> some = {{Axis::Kind::define, "FIXED", {"3"}, false}, axes[0], axes[1]};
  const Point point = {"3", "1", "16"};
  EXPECT_EQ(label(some, point), "SCENE=1 STEPS=16");
  EXPECT_EQ(case_label(some, point), "SCENE=1");
  EXPECT_EQ(variant_label(some, point), "STEPS=16");
  EXPECT_EQ(variant_label(some, point, {"3", "0", "8"}), "STEPS=16");
  EXPECT_EQ(variant_label(some, point, point), "default");
}

}  // namespace
}  // namespace shadertwin::sweep
