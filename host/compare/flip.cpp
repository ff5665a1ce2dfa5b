#include "host/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>
#include <numeric>
#include <vector>

#include "host/base/assert.h"

// Equation numbers are those of the paper.
namespace shadertwin {

namespace {

using glm::dvec2;
using glm::dvec3;

struct Plane {
  int width = 0;
  int height = 0;
  std::vector<dvec3> values;

  // Beyond the border the nearest pixel's.
  const dvec3& at(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// --- Colours ----------------------------------------------------------------

// BT.709's primaries in CIE XYZ; together they are D65.
const glm::dmat3 rgb_to_xyz(0.4123907993, 0.2126390059, 0.0193308187,   // red
                            0.3575843394, 0.7151686788, 0.1191947798,   // green
                            0.1804807884, 0.0721923154, 0.9505321522);  // blue

dvec3 white() {
  return rgb_to_xyz * dvec3(1.0);
}

double srgb_decode(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Linear and opponent: luminance, red against green, blue against yellow.
dvec3 to_opponent(const dvec3& rgb) {
  const dvec3 v = rgb_to_xyz * rgb / white();
  return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
}

dvec3 from_opponent(const dvec3& c) {
  const double y = (c.x + 16.0) / 116.0;
  return glm::inverse(rgb_to_xyz) * (dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * white());
}

// CIE L*a*b*, its colours weighted by lightness as the Hunt effect asks.
dvec3 to_perceived(const dvec3& rgb) {
  const dvec3 v = rgb_to_xyz * rgb / white();
  const auto f = [](double t) {
    constexpr double d = 6.0 / 29.0;
    return t > d * d * d ? std::cbrt(t) : t / (3.0 * d * d) + 4.0 / 29.0;
  };
  const double lightness = 116.0 * f(v.y) - 16.0;
  const double weight = 0.01 * lightness;
  return {lightness, weight * 500.0 * (f(v.x) - f(v.y)), weight * 200.0 * (f(v.y) - f(v.z))};
}

// HyAB (Abasi, Amani Tehran, Fairchild 2020), which holds for large differences, too.
double colour_distance(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) + glm::length(dvec2(a.y - b.y, a.z - b.z));
}

// --- Filters ----------------------------------------------------------------

// A weight for each offset from -radius to radius.
using Kernel = std::vector<double>;

Kernel make_kernel(int radius, const std::function<double(double)>& f) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(f(i));
  return kernel;
}

// Along rows, then along columns, a kernel each for every channel.
Plane filter(const Plane& plane, const std::array<Kernel, 3>& along_x, const std::array<Kernel, 3>& along_y) {
  const auto pass = [](const Plane& in, const std::array<Kernel, 3>& kernels, int dx, int dy) {
    const int radius = static_cast<int>(kernels[0].size()) / 2;
    Plane out = in;
    for (int y = 0; y < in.height; ++y)
      for (int x = 0; x < in.width; ++x) {
        dvec3 sum(0.0);
        for (int i = -radius; i <= radius; ++i) {
          const auto k = static_cast<std::size_t>(i + radius);
          sum += dvec3(kernels[0][k], kernels[1][k], kernels[2][k]) * in.at(x + i * dx, y + i * dy);
        }
        out.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(in.width) +
                   static_cast<std::size_t>(x)] = sum;
      }
    return out;
  };
  return pass(pass(plane, along_x, 1, 0), along_y, 0, 1);
}

// The eye's contrast sensitivity as sums of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (eq. 4,
// table 1). Their product over x and y is a Gaussian again, so that each is filtered apart and its share
// added.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities = {
    Sensitivity{1.0, 0.0047, 0.0, 1e-5},  // luminance
    Sensitivity{1.0, 0.0053, 0.0, 1e-5},  // red against green
    Sensitivity{34.1, 0.04, 13.5, 0.025}  // blue against yellow
};

Plane filter_as_the_eye_does(const Plane& plane, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const double pi = std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * pixels_per_degree));
  Plane result{plane.width, plane.height, std::vector<dvec3>(plane.values.size(), dvec3(0.0))};
  dvec3 total(0.0);
  for (int term = 0; term < 2; ++term) {
    std::array<Kernel, 3> kernels;
    dvec3 share;
    for (int channel = 0; channel < 3; ++channel) {
      const Sensitivity& s = sensitivities[static_cast<std::size_t>(channel)];
      const double a = term == 0 ? s.a1 : s.a2;
      const double b = term == 0 ? s.b1 : s.b2;
      Kernel kernel = make_kernel(radius, [&](double i) {
        const double x = i / pixels_per_degree;
        return std::exp(-pi * pi * x * x / b);
      });
      double sum = 0.0;
      for (const double k : kernel) sum += k;
      for (double& k : kernel) k /= sum;
      share[channel] = a * std::sqrt(pi / b) * sum * sum;
      kernels[static_cast<std::size_t>(channel)] = std::move(kernel);
    }
    total += share;
    const Plane filtered = filter(plane, kernels, kernels);
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] += share * filtered.values[i];
  }
  for (dvec3& value : result.values) value /= total;
  return result;
}

// How strong an edge and a point stand at every pixel of the luminance (x and y of the result), eq. 10 to 12.
std::vector<dvec2> features(const Plane& opponent, double pixels_per_degree) {
  const double sigma = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
  Kernel smooth = make_kernel(radius, gaussian);
  double sum = 0.0;
  for (const double k : smooth) sum += k;
  for (double& k : smooth) k /= sum;
  // What is positive adds up to 1, what is negative to -1.
  const auto balanced = [](Kernel kernel) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double k : kernel) (k > 0.0 ? positive : negative) += std::abs(k);
    for (double& k : kernel) k /= k > 0.0 ? positive : negative;
    return kernel;
  };
  const Kernel edge = balanced(make_kernel(radius, [&](double x) { return -x * gaussian(x); }));
  const Kernel point =
      balanced(make_kernel(radius, [&](double x) { return (x * x / (sigma * sigma) - 1.0) * gaussian(x); }));

  Plane luminance = opponent;
  for (dvec3& value : luminance.values) value = dvec3((value.x + 16.0) / 116.0);
  // Channels: edge, point, unused.
  const Plane across = filter(luminance, {edge, point, point}, {smooth, smooth, smooth});
  const Plane along = filter(luminance, {smooth, smooth, smooth}, {edge, point, point});
  std::vector<dvec2> result(luminance.values.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {std::hypot(across.values[i].x, along.values[i].x),
                 std::hypot(across.values[i].y, along.values[i].y)};
  return result;
}

Plane shown_on_a_canvas(const Image& image) {
  Plane plane{image.width, image.height, {}};
  plane.values.reserve(image.rgba.size() / 4);
  const auto linear = [](float value) {
    return srgb_decode(std::isnan(value) ? 0.0 : std::clamp(static_cast<double>(value), 0.0, 1.0));
  };
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    plane.values.emplace_back(linear(image.rgba[i]), linear(image.rgba[i + 1]), linear(image.rgba[i + 2]));
  return plane;
}

}  // namespace

Flip::Flip(const Image& reference, double pixels_per_degree)
    : pixels_per_degree_(pixels_per_degree), reference_(see(reference, pixels_per_degree)) {}

Flip::Seen Flip::see(const Image& image, double pixels_per_degree) {
  Plane plane = shown_on_a_canvas(image);
  for (dvec3& value : plane.values) value = to_opponent(value);
  Seen seen{image.width, image.height, {}, features(plane, pixels_per_degree)};
  seen.colors = filter_as_the_eye_does(plane, pixels_per_degree).values;
  for (dvec3& value : seen.colors) value = to_perceived(glm::clamp(from_opponent(value), 0.0, 1.0));
  return seen;
}

std::vector<double> Flip::differences(const Image& picture) const {
  SHADERTWIN_ASSERT_EQ(picture.width, reference_.width);
  SHADERTWIN_ASSERT_EQ(picture.height, reference_.height);
  constexpr double exponent = 0.7;   // of colour differences, eq. 8
  constexpr double low_share = 0.4;  // of the largest difference, and what it becomes, eq. 9
  constexpr double low_result = 0.95;
  const double largest = std::pow(
      colour_distance(to_perceived(dvec3(0.0, 1.0, 0.0)), to_perceived(dvec3(0.0, 0.0, 1.0))), exponent);
  const double low = low_share * largest;

  const Seen seen = see(picture, pixels_per_degree_);
  std::vector<double> result(seen.colors.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double raw = std::pow(colour_distance(seen.colors[i], reference_.colors[i]), exponent);
    const double colour =
        raw < low ? low_result / low * raw : low_result + (raw - low) / (largest - low) * (1.0 - low_result);
    const dvec2 change = glm::abs(seen.features[i] - reference_.features[i]);
    const double feature = std::sqrt(std::max(change.x, change.y) / std::numbers::sqrt2);
    result[i] = std::pow(std::min(colour, 1.0), 1.0 - std::min(feature, 1.0));  // eq. 13 to 15
  }
  return result;
}

double Flip::mean(const Image& picture) const {
  const std::vector<double> all = differences(picture);
  return all.empty() ? 0.0 : std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

Image Flip::map(const Image& picture) const {
  const std::vector<double> all = differences(picture);
  Image map(picture.width, picture.height);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::fill_n(&map.rgba[4 * i], 3, static_cast<float>(all[i]));
    map.rgba[4 * i + 3] = 1.0F;
  }
  return map;
}

}  // namespace shadertwin
