#include "host/compare/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/base/assert.h"

namespace shadertwin {

namespace {

// Floats in their order as integers: neighbours are one apart, and both zeros are 0.
std::int64_t ordered(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits >= 0 ? bits : -static_cast<std::int64_t>(bits & 0x7FFFFFFF);
}

bool same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

std::uint32_t percentile(std::vector<std::uint32_t>& distances, double share) {
  if (distances.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[static_cast<std::size_t>(rank)];
}

}  // namespace

glm::vec3 heat(float x) {
  static constexpr std::array<glm::vec3, 5> stops = {glm::vec3(0.1F, 0.2F, 0.8F), glm::vec3(0.0F, 0.7F, 0.8F),
                                                     glm::vec3(0.2F, 0.8F, 0.2F), glm::vec3(1.0F, 0.9F, 0.1F),
                                                     glm::vec3(0.9F, 0.1F, 0.1F)};
  const float at = std::clamp(x, 0.0F, 1.0F) * static_cast<float>(stops.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return glm::mix(stops[left], stops[left + 1], at - static_cast<float>(left));
}

std::uint32_t ulp_distance(float a, float b) {
  if (std::isnan(a) && std::isnan(b)) return 0;
  if (std::isnan(a) || std::isnan(b)) return nan_distance;
  return static_cast<std::uint32_t>(std::abs(ordered(a) - ordered(b)));
}

std::array<ChannelDifference, 4> compare(const Image& a, const Image& b) {
  SHADERTWIN_ASSERT_EQ(a.width, b.width);
  SHADERTWIN_ASSERT_EQ(a.height, b.height);
  std::array<ChannelDifference, 4> result;
  const std::size_t pixels = a.rgba.size() / 4;
  std::vector<std::uint32_t> distances(pixels);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    ChannelDifference& difference = result[channel];
    difference.pixels = pixels;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::array<float, 2> values = {a.rgba[4 * i + channel], b.rgba[4 * i + channel]};
      for (std::size_t side = 0; side < 2; ++side) {
        if (std::isnan(values[side])) ++difference.nan[side];
        if (std::isinf(values[side])) ++difference.infinite[side];
      }
      if (same(values[0], values[1])) ++difference.equal;
      distances[i] = ulp_distance(values[0], values[1]);
      if (distances[i] > distances[worst]) worst = i;
    }
    if (pixels == 0) continue;
    difference.worst_x = static_cast<int>(worst) % a.width;
    difference.worst_y = static_cast<int>(worst) / a.width;
    difference.worst = {a.rgba[4 * worst + channel], b.rgba[4 * worst + channel]};
    difference.ulp_max = distances[worst];
    difference.ulp_p50 = percentile(distances, 0.50);
    difference.ulp_p99 = percentile(distances, 0.99);
  }
  return result;
}

Image heatmap(const Image& a, const Image& b) {
  SHADERTWIN_ASSERT_EQ(a.rgba.size(), b.rgba.size());
  Image map(a.width, a.height);
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    std::uint32_t distance = 0;
    bool equal = true;
    for (std::size_t channel = i; channel < i + 4; ++channel) {
      equal = equal && same(a.rgba[channel], b.rgba[channel]);
      distance = std::max(distance, ulp_distance(a.rgba[channel], b.rgba[channel]));
    }
    glm::vec3 color(0.0F);
    if (distance == nan_distance)
      color = {1.0F, 0.0F, 1.0F};
    else if (!equal)
      color = heat(std::log2(static_cast<float>(std::max(distance, 1U))) / 31.0F);
    map.rgba[i] = color.r;
    map.rgba[i + 1] = color.g;
    map.rgba[i + 2] = color.b;
    map.rgba[i + 3] = 1.0F;
  }
  return map;
}

}  // namespace shadertwin
