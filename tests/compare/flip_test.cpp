#include "host/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/glm.hpp>

#include "tests/flat_image.h"

namespace shadertwin {
namespace {

constexpr int width = 24;
constexpr int height = 16;

Image picture(const std::function<glm::dvec3(int, int)>& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 c = color(x, y);
      for (int i = 0; i < 3; ++i) image.at(x, y)[i] = static_cast<float>(c[i]);
      image.at(x, y)[3] = 1.0F;
    }
  return image;
}

Image flat(double r, double g, double b) {
  return flat_image(width, height, static_cast<float>(r), static_cast<float>(g), static_cast<float>(b));
}

double flip(const Image& picture, const Image& reference, double pixels_per_degree = flip_pixels_per_degree) {
  return Flip(reference, pixels_per_degree).mean(picture);
}

Image patches() {
  return picture([](int x, int y) {
    return glm::dvec3((x * 7 + y * 3) % 11 / 10.0, (x * 5 + y * 13) % 17 / 16.0, ((x / 6 + y / 5) % 2) * 0.8);
  });
}

Image changed_patches() {
  const Image original = patches();
  return picture([&](int x, int y) {
    const float* c = original.at(x, y);
    return glm::dvec3(std::min(1.0, c[0] * 0.9 + 0.05), std::pow(c[1], 1.2), 0.5 * c[2] + 0.2);
  });
}

// The expected values come from another program, which evaluates the paper's equations in double precision
// with whole two-dimensional kernels.
TEST(Flip, IsWhatThePapersEquationsGive) {
  EXPECT_NEAR(flip(patches(), changed_patches()), 0.35546812, 1e-5);
  EXPECT_NEAR(flip(patches(), changed_patches(), 20.0), 0.38407736, 1e-5);
  EXPECT_NEAR(flip(flat(0, 0, 0), flat(1, 1, 1)), 0.96737918, 1e-6);
  EXPECT_NEAR(flip(flat(0.5, 0.5, 0.5), flat(0.5, 0.5, 0.52)), 0.08421285, 1e-5);
  const Image step = picture([](int x, int) { return glm::dvec3(x < 12 ? 0.0 : 1.0); });
  EXPECT_NEAR(flip(step, flat(0.5, 0.5, 0.5)), 0.91296943, 1e-5);
}

TEST(Flip, GoesFromEqualToGreenAgainstBlue) {
  EXPECT_EQ(flip(patches(), patches()), 0.0);
  EXPECT_NEAR(flip(flat(0, 1, 0), flat(0, 0, 1)), 1.0, 1e-6);
}

TEST(Flip, IsOfWhatACanvasShows) {
  EXPECT_EQ(flip(flat(4, 1, -2), flat(1, 1, 0)), 0.0);
  EXPECT_EQ(flip(flat(NAN, 0, 0), flat(0, 0, 0)), 0.0);
}

TEST(FlipMap, HasTheDifferenceWhereItIs) {
  Image spot = flat(0.2, 0.2, 0.2);
  std::fill_n(spot.at(4, 8), 3, 1.0F);
  const Image map = Flip(flat(0.2, 0.2, 0.2)).map(spot);
  EXPECT_GT(*map.at(4, 8), 0.5F);
  EXPECT_LT(*map.at(23, 8), 0.05F);
}

}  // namespace
}  // namespace shadertwin
