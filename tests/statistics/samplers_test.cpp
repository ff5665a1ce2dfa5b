// Warps, the lens, the shutter and the points of a light: densities against closed distribution functions.
#include <cmath>
#include <numbers>

#include "tests/shadertoy/shapes.h"
#include "tests/statistics/statistics.h"

namespace shadertwin {
namespace {

SHADERTWIN_STATISTICS(Samplers);

using std::numbers::pi;

constexpr std::size_t million = std::size_t{1} << 20;
const Probe disk{.file = "warps.glsl", .function = 0};
const Probe unit_vector{.file = "warps.glsl", .function = 1};
const Probe ball{.file = "warps.glsl", .function = 2};
const Probe hemisphere{.file = "hemisphere.glsl", .inputs = 2, .outputs = 3};
const Probe rays{.file = "camera_rays.glsl", .inputs = 6, .outputs = 5};
const Probe lights{.file = "lights.glsl", .inputs = 5, .outputs = 3};

Table random_inputs(std::uint64_t seed, int size = 1) {
  Random random = draw(seed);
  Table inputs(million, size);
  for (std::size_t i = 0; i < million; ++i)
    inputs.at(i, 0) = glm::vec4(random.uniform(), random.uniform(), random.uniform(), random.uniform());
  return inputs;
}

// Angle over a turn, in [0, 1).
double turn_of(double y, double x) {
  const double t = std::atan2(y, x) / (2.0 * pi);
  return std::min(t < 0.0 ? t + 1.0 : t, 1.0 - 1e-12);
}

TEST_P(Samplers, DiskIsUniform) {
  const Table got = run(disk, random_inputs(11));
  std::vector<double> r2;
  std::vector<double> phi;
  std::vector<double> x2;
  for (std::size_t i = 0; i < million; ++i) {
    const auto x = static_cast<double>(got.at(i, 0).x);
    const auto y = static_cast<double>(got.at(i, 0).y);
    r2.push_back(std::min(x * x + y * y, 1.0));
    phi.push_back(turn_of(y, x));
    x2.push_back(x * x);
  }
  expect_uniform("r^2", r2);
  expect_uniform("angle", phi);
  expect_uniform_pairs("r^2 and angle", r2, phi);
  expect_mean("x^2", x2, 0.25, 1e-7);
}

TEST_P(Samplers, UnitVectorsAreUniformOnTheSphere) {
  const Table got = run(unit_vector, random_inputs(12));
  std::vector<double> z;
  std::vector<double> phi;
  std::vector<double> z2;
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 d(got.at(i, 0));
    z.push_back(std::clamp(0.5 * (d.z + 1.0), 0.0, 1.0));
    phi.push_back(turn_of(d.y, d.x));
    z2.push_back(d.z * d.z);
  }
  expect_uniform("height", z);
  expect_uniform("angle", phi);
  expect_uniform_pairs("height and angle", z, phi);
  expect_mean("z^2", z2, 1.0 / 3.0, 1e-7);
}

TEST_P(Samplers, BallIsUniform) {
  const Table got = run(ball, random_inputs(13));
  std::vector<double> r3;
  std::vector<double> z;
  std::vector<double> phi;
  std::vector<double> r2;
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 p(got.at(i, 0));
    const double r = glm::length(p);
    r3.push_back(std::min(r * r * r, 1.0));
    r2.push_back(r * r);
    z.push_back(r > 0.0 ? std::clamp(0.5 * (p.z / r + 1.0), 0.0, 1.0) : 0.5);
    phi.push_back(turn_of(p.y, p.x));
  }
  expect_uniform("r^3", r3);
  expect_uniform("height", z);
  expect_uniform("angle", phi);
  expect_uniform_pairs("r^3 and height", r3, z);
  expect_mean("r^2", r2, 0.6, 1e-6);
}

TEST_P(Samplers, CosineHemisphereHasTheDensityOfTheCosine) {
  // Two poles of the basis, and a normal between.
  const std::vector<glm::vec3> all = {{0, 0, 1}, {0, 0, -1}, glm::vec3(glm::normalize(glm::dvec3(1, 2, -3)))};
  for (std::size_t k = 0; k < all.size(); ++k) {
    Table inputs = random_inputs(14 + k, 2);
    for (std::size_t i = 0; i < million; ++i) inputs.at(i, 1) = glm::vec4(all[k], 0);
    const Table got = run(hemisphere, inputs);
    const glm::dvec3 n(all[k]);
    std::vector<double> cosine;
    std::vector<double> cosine2;
    std::vector<double> phi;
    for (std::size_t i = 0; i < million; ++i) {
      const glm::dvec3 d(got.at(i, 0));
      const double c = glm::dot(d, n);
      cosine.push_back(c);
      cosine2.push_back(std::clamp(c * c, 0.0, 1.0));
      phi.push_back(turn_of(glm::dot(d, glm::dvec3(got.at(i, 2))), glm::dot(d, glm::dvec3(got.at(i, 1)))));
    }
    const std::string name = "normal " + std::to_string(k);
    expect_uniform(name + ", cos^2", cosine2);
    expect_uniform(name + ", angle", phi);
    expect_uniform_pairs(name + ", cos^2 and angle", cosine2, phi);
    expect_mean(name + ", cos", cosine, 2.0 / 3.0, 1e-6);
  }
}

TEST_P(Samplers, LensIsADiskAndTheShutterIsEven) {
  Table inputs(million / 4, 6);
  Random random = draw(18);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    inputs.at(i, 0) = texel({0, 0, 0});
    inputs.at(i, 1) = texel({0, 0, -5});
    inputs.at(i, 2) = texel({0, 1, 0});
    inputs.at(i, 3) = {50, 1.5, 4, 1.2F};
    inputs.at(i, 4) = glm::vec4(1, 3, random.uniform(), random.uniform());
    inputs.at(i, 5) = texel({random.uniform(), random.uniform(), random.uniform()});
  }
  const Table got = run(rays, inputs);
  std::vector<double> r2;
  std::vector<double> phi;
  std::vector<double> time;
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const glm::dvec4 o(got.at(i, 0));
    r2.push_back(std::min((o.x * o.x + o.y * o.y) / 4.0, 1.0));
    phi.push_back(turn_of(o.y, o.x));
    time.push_back(0.5 * (o.w - 1.0));
  }
  expect_uniform("lens, r^2", r2);
  expect_uniform("lens, angle", phi);
  expect_uniform_pairs("lens, r^2 and angle", r2, phi);
  expect_uniform("time", time);
  expect_uniform_pairs("time and r^2", time, r2);
}

TEST_P(Samplers, PointsOfALightAreEven) {
  const glm::dvec3 shapes[][3] = {{{-5, 12, -2}, {10, 0, 0}, {0, 0, 5}},
                                  {{1, 2, 3}, {0.3, 2, -1}, {1, 1, 0.2}}};
  int number = 0;
  for (const auto& [corner, e1, e2] : shapes) {
    Table inputs(million / 4, 5);
    Random random = draw(19);
    for (std::size_t i = 0; i < inputs.cases(); ++i) {
      inputs.at(i, 0) = texel(corner);
      inputs.at(i, 1) = texel(e1);
      inputs.at(i, 2) = texel(e2);
      inputs.at(i, 4) = glm::vec4(random.uniform(), random.uniform(), 1, 1);
    }
    const Table got = run(lights, inputs);
    // Coordinates along the edges, from areas.
    const glm::dvec3 n = glm::cross(e1, e2);
    std::vector<double> along1;
    std::vector<double> along2;
    for (std::size_t i = 0; i < inputs.cases(); ++i) {
      const glm::dvec3 p = glm::dvec3(got.at(i, 0)) - corner;
      along1.push_back(std::clamp(glm::dot(glm::cross(p, e2), n) / glm::dot(n, n), 0.0, 1.0));
      along2.push_back(std::clamp(glm::dot(glm::cross(e1, p), n) / glm::dot(n, n), 0.0, 1.0));
    }
    expect_uniform_pairs("light " + std::to_string(number++), along1, along2);
  }
}

}  // namespace
}  // namespace shadertwin
