#include "tools/cubemap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadertwin {

Direction face_direction(int face, double s, double t) {
  const double sc = 2 * s - 1, tc = 2 * t - 1;
  switch (face) {
    case 0:
      return {1, -tc, -sc};
    case 1:
      return {-1, -tc, sc};
    case 2:
      return {sc, 1, tc};
    case 3:
      return {sc, -1, -tc};
    case 4:
      return {sc, -tc, 1};
    default:
      return {-sc, -tc, -1};
  }
}

std::array<double, 2> map_position(const Direction& d) {
  const double length = std::hypot(d[0], d[1], d[2]);
  return {std::atan2(d[2], d[0]) / (2 * std::numbers::pi) + 0.5,
          std::asin(d[1] / length) / std::numbers::pi + 0.5};
}

namespace {

using Colour = std::array<double, 3>;

// Bilinear, around the map in u and held at the poles in v.
Colour sample(const Image& map, std::array<double, 2> position) {
  const double x = position[0] * map.width - 0.5, y = position[1] * map.height - 0.5;
  const int left = static_cast<int>(std::floor(x)), below = static_cast<int>(std::floor(y));
  Colour sum{};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const float* texel =
          map.at((left + i + map.width) % map.width, std::clamp(below + j, 0, map.height - 1));
      const double weight = (i ? x - left : left + 1 - x) * (j ? y - below : below + 1 - y);
      for (int c = 0; c < 3; ++c) sum[c] += weight * std::max(0.0f, texel[c]);
    }
  return sum;
}

}  // namespace

Image cube_face(const Image& map, int face, int size, int samples) {
  Image result(size, size);
  const double step = 1.0 / (static_cast<double>(size) * samples);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      Colour sum{};
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const double s = (x * samples + i + 0.5) * step, t = 1 - (y * samples + j + 0.5) * step;
          const Colour colour = sample(map, map_position(face_direction(face, s, t)));
          for (int c = 0; c < 3; ++c) sum[c] += colour[c];
        }
      float* const texel = result.at(x, y);
      for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(sum[c] / (samples * samples));
      texel[3] = 1;
    }
  return result;
}

void encode_srgb(Image& image, double stops) {
  const double scale = std::exp2(stops);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 == 3) {
      image.rgba[i] = 1;
      continue;
    }
    const double linear = std::clamp(scale * image.rgba[i], 0.0, 1.0);
    image.rgba[i] =
        static_cast<float>(linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
  }
}

}  // namespace shadertwin
