#include "host/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shadertwin {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(UlpDistance, CountsFloatsBetweenTwoNumbers) {
  EXPECT_EQ(ulp_distance(1.0F, 1.0F), 0U);
  EXPECT_EQ(ulp_distance(1.0F, std::nextafter(1.0F, 2.0F)), 1U);
  EXPECT_EQ(ulp_distance(1.0F, 2.0F), 1U << 23);
  EXPECT_EQ(ulp_distance(0.0F, -0.0F), 0U);
  const float smallest = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(ulp_distance(-smallest, smallest), 2U);
  EXPECT_EQ(ulp_distance(std::numeric_limits<float>::max(), infinity), 1U);
  EXPECT_EQ(ulp_distance(-infinity, infinity), 2U * 0x7F800000U);
  EXPECT_EQ(ulp_distance(nan, nan), 0U);
  EXPECT_EQ(ulp_distance(nan, 1.0F), nan_distance);
  EXPECT_EQ(ulp_distance(1.0F, nan), nan_distance);
}

Image ramp_image() {
  Image image(10, 10);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<float>(i) + 1.0F;
  return image;
}

TEST(Compare, SamePicturesAreEqualInEveryChannel) {
  Image image = ramp_image();
  image.at(1, 1)[0] = nan;
  for (const ChannelDifference& channel : compare(image, image)) {
    EXPECT_EQ(channel.equal_share(), 1.0);
    EXPECT_EQ(channel.ulp_max, 0U);
  }
  EXPECT_EQ(compare(image, image)[0].nan[0], 1U);
}

TEST(Compare, NamesTheWorstPixelAndItsValues) {
  const Image a = ramp_image();
  Image b = a;
  b.at(3, 7)[1] += 1.0F;
  b.at(4, 7)[1] = std::nextafter(b.at(4, 7)[1], 0.0F);
  const auto difference = compare(a, b);
  EXPECT_EQ(difference[0].equal, 100U);
  EXPECT_EQ(difference[1].equal, 98U);
  EXPECT_EQ(difference[1].worst_x, 3);
  EXPECT_EQ(difference[1].worst_y, 7);
  EXPECT_EQ(difference[1].worst[0], a.at(3, 7)[1]);
  EXPECT_EQ(difference[1].worst[1], a.at(3, 7)[1] + 1.0F);
  EXPECT_EQ(difference[1].ulp_p50, 0U);
  EXPECT_EQ(difference[1].ulp_max, ulp_distance(a.at(3, 7)[1], b.at(3, 7)[1]));
}

TEST(Compare, PercentilesAreThoseOfTheSortedDistances) {
  Image a(100, 1);
  Image b(100, 1);
  for (int x = 0; x < 100; ++x) {
    a.at(x, 0)[2] = 1.0F;
    b.at(x, 0)[2] = 1.0F + static_cast<float>(x) * std::numeric_limits<float>::epsilon();
  }
  const ChannelDifference blue = compare(a, b)[2];
  EXPECT_EQ(blue.ulp_p50, 49U);
  EXPECT_EQ(blue.ulp_p99, 98U);
  EXPECT_EQ(blue.ulp_max, 99U);
}

TEST(Compare, CountsNanAndInfinityOfEachSide) {
  Image a = ramp_image();
  Image b = ramp_image();
  a.at(0, 0)[3] = nan;
  b.at(1, 0)[3] = infinity;
  b.at(2, 0)[3] = -infinity;
  const ChannelDifference alpha = compare(a, b)[3];
  EXPECT_EQ(alpha.nan, (std::array<std::size_t, 2>{1, 0}));
  EXPECT_EQ(alpha.infinite, (std::array<std::size_t, 2>{0, 2}));
  EXPECT_EQ(alpha.ulp_max, nan_distance);
}

TEST(Compare, SignOfZeroIsADifferenceOfBitsButNotOfValue) {
  Image a(1, 1);
  Image b(1, 1);
  b.rgba[0] = -0.0F;
  EXPECT_EQ(compare(a, b)[0].equal, 0U);
  EXPECT_EQ(compare(a, b)[0].ulp_max, 0U);
}

TEST(Heatmap, IsBlackWhereEqualAndHotterWithDistance) {
  const Image a = ramp_image();
  Image b = a;
  b.at(1, 0)[0] = std::nextafter(b.at(1, 0)[0], 0.0F);
  b.at(2, 0)[0] = -b.at(2, 0)[0];
  b.at(3, 0)[0] = nan;
  const Image map = heatmap(a, b);
  EXPECT_EQ(map.at(0, 0)[0] + map.at(0, 0)[1] + map.at(0, 0)[2], 0.0F);
  EXPECT_GT(map.at(1, 0)[2], map.at(1, 0)[0]);  // one step: blue
  EXPECT_GT(map.at(2, 0)[0], map.at(2, 0)[2]);  // the other sign: red
  EXPECT_EQ(map.at(3, 0)[0], 1.0F);             // magenta
  EXPECT_EQ(map.at(3, 0)[1], 0.0F);
  EXPECT_EQ(map.at(3, 0)[2], 1.0F);
}

}  // namespace
}  // namespace shadertwin
