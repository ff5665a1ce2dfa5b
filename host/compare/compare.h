// How far two pictures of the same frame are apart, in units in the last place.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "host/image/image.h"

namespace shadertwin {

// Steps from one float to the next that lie between two numbers; -0 and +0 are the same number, and infinity
// is the step after the largest number. Both NaN: 0. One NaN: the largest value there is.
std::uint32_t ulp_distance(float a, float b);
constexpr std::uint32_t nan_distance = 0xFFFFFFFF;

struct ChannelDifference {
  std::size_t pixels = 0;
  std::size_t equal = 0;  // the same bits, or both NaN
  std::uint32_t ulp_p50 = 0;
  std::uint32_t ulp_p99 = 0;
  std::uint32_t ulp_max = 0;
  // Of each picture, as they are: nothing has been clamped.
  std::array<std::size_t, 2> nan{};
  std::array<std::size_t, 2> infinite{};
  // Where the distance is largest (the first such pixel, from the lower left), with both values.
  int worst_x = 0;
  int worst_y = 0;
  std::array<float, 2> worst{};

  double equal_share() const {
    return pixels == 0 ? 1.0 : static_cast<double>(equal) / static_cast<double>(pixels);
  }
};

// One entry for each of r, g, b and a. The pictures must have one size.
std::array<ChannelDifference, 4> compare(const Image& a, const Image& b);

// The colours of heat maps: blue to red as x goes from 0 to 1.
glm::vec3 heat(float x);

// A picture of where they differ: black where all four channels have the same bits, then blue, green, yellow
// and red with the logarithm of the largest distance (1 ULP to 2^31), magenta where just one of the two is
// NaN.
Image heatmap(const Image& a, const Image& b);

}  // namespace shadertwin
