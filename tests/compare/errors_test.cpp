#include "host/compare/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/flat_image.h"

namespace shadertwin {
namespace {

Image plain(float r, float g, float b, int side = 4) {
  return flat_image(side, side, r, g, b);
}

TEST(PictureError, IsTheMeanOfSquaresAndOfThoseInUnitsOfTheReference) {
  const PictureError error = picture_error(plain(1.0F, 2.0F, 0.0F), plain(1.0F, 1.0F, 0.5F));
  EXPECT_EQ(error.values, 48U);
  EXPECT_NEAR(error.mse, (0.0 + 1.0 + 0.25) / 3.0, 1e-12);
  EXPECT_NEAR(error.relative_mse, (1.0 / 1.01 + 0.25 / 0.26) / 3.0, 1e-12);
}

TEST(PictureError, LooksAtNoAlpha) {
  Image a = plain(0.5F, 0.5F, 0.5F);
  a.rgba[3] = 100.0F;
  EXPECT_EQ(picture_error(a, plain(0.5F, 0.5F, 0.5F)).mse, 0.0);
}

TEST(PictureError, CountsWhatIsNoNumberAndLeavesItOut) {
  Image a = plain(1.0F, 1.0F, 1.0F);
  a.rgba[0] = std::numeric_limits<float>::quiet_NaN();
  a.rgba[5] = -std::numeric_limits<float>::infinity();
  const PictureError error = picture_error(a, plain(0.0F, 0.0F, 0.0F));
  EXPECT_EQ(error.nan, 1U);
  EXPECT_EQ(error.infinite, 1U);
  EXPECT_EQ(error.values, 46U);
  EXPECT_NEAR(error.mse, 1.0, 1e-12);

  const PictureError nothing_left = picture_error(plain(NAN, NAN, NAN), plain(0.0F, 0.0F, 0.0F));
  EXPECT_EQ(nothing_left.values, 0U);
  EXPECT_EQ(nothing_left.mse, 0.0);
}

TEST(ErrorParts, TellBiasFromNoise) {
  std::mt19937 random(7);
  std::normal_distribution<float> noise(0.0F, 0.2F);
  const auto noisy = [&](float mean, float share = 1.0F) {
    Image image = plain(mean, mean, mean, 256);
    for (float& value : image.rgba) value += share * noise(random);
    return image;
  };
  const Image reference = plain(1.0F, 1.0F, 1.0F, 256);
  constexpr double unit = 1.0 / 1.01;  // of a relative error where the reference is 1
  // 196,608 values: the standard error of each estimate is below 0.0002.
  const ErrorParts unbiased = error_parts(noisy(1.0F), noisy(1.0F), reference, reference);
  EXPECT_NEAR(unbiased.relative_variance, 0.04 * unit, 0.001);
  EXPECT_NEAR(unbiased.relative_bias2, 0.0, 0.001);
  const Image a = noisy(1.1F);
  const Image b = noisy(1.1F);
  const ErrorParts biased = error_parts(a, b, reference, reference);
  EXPECT_NEAR(biased.relative_variance, 0.04 * unit, 0.001);
  EXPECT_NEAR(biased.relative_bias2, 0.01 * unit, 0.001);
  EXPECT_NEAR(biased.relative_bias2 + biased.relative_variance,
              0.5 * (picture_error(a, reference).relative_mse + picture_error(b, reference).relative_mse),
              1e-9);

  const ErrorParts noisy_references =
      error_parts(noisy(1.0F), noisy(1.0F), noisy(1.0F, 0.3F), noisy(1.0F, 0.3F));
  // Of one reference it would be 0.0036.
  EXPECT_NEAR(noisy_references.relative_bias2, 0.0, 0.001);
}

}  // namespace
}  // namespace shadertwin
