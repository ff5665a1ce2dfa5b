// Warps, the lens, the shutter and the points of a light: densities against closed distribution functions.
#include <cmath>
#include <numbers>

#include "tests/shadertoy/shapes.h"
#include "tests/shadertoy/warps.h"
#include "tests/statistics/statistics.h"

namespace shadertwin::samplers_test {
namespace {

SHADERTWIN_STATISTICS(Samplers);

using std::numbers::pi;

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

// The azimuth over a turn.
double turn_around_z(const glm::dvec4& p) {
  return turn_of(p.y, p.x);
}

TEST_P(Samplers, DiskIsUniform) {
  const Table got = run(warps::disk, random_inputs(11));
  const auto r2 = column(got, [](const auto& p) { return std::min(p.x * p.x + p.y * p.y, 1.0); });
  const auto phi = column(got, turn_around_z);
  expect_uniform("r^2", r2);
  expect_uniform("angle", phi);
  expect_uniform_pairs("r^2 and angle", r2, phi);
  expect_mean("x^2", column(got, [](const auto& p) { return p.x * p.x; }), 0.25, 1e-7);
}

TEST_P(Samplers, UnitVectorsAreUniformOnTheSphere) {
  const Table got = run(warps::unit_vector, random_inputs(12));
  const auto z = column(got, [](const auto& d) { return std::clamp(0.5 * (d.z + 1.0), 0.0, 1.0); });
  const auto phi = column(got, turn_around_z);
  expect_uniform("height", z);
  expect_uniform("angle", phi);
  expect_uniform_pairs("height and angle", z, phi);
  expect_mean("z^2", column(got, [](const auto& d) { return d.z * d.z; }), 1.0 / 3.0, 1e-7);
}

TEST_P(Samplers, BallIsUniform) {
  const Table got = run(warps::ball, random_inputs(13));
  const auto radius = [](const glm::dvec4& p) { return glm::length(glm::dvec3(p)); };
  const auto r3 =
      column(got, [&](const auto& p) { return std::min(radius(p) * radius(p) * radius(p), 1.0); });
  const auto z = column(got, [&](const auto& p) {
    const double r = radius(p);
    return r > 0.0 ? std::clamp(0.5 * (p.z / r + 1.0), 0.0, 1.0) : 0.5;
  });
  expect_uniform("r^3", r3);
  expect_uniform("height", z);
  expect_uniform("angle", column(got, turn_around_z));
  expect_uniform_pairs("r^3 and height", r3, z);
  expect_mean("r^2", column(got, [&](const auto& p) { return radius(p) * radius(p); }), 0.6, 1e-6);
}

TEST_P(Samplers, CosineHemisphereHasTheDensityOfTheCosine) {
  // Two poles of the basis, and a normal between.
  const std::vector<glm::vec3> all = {{0, 0, 1}, {0, 0, -1}, glm::vec3(glm::normalize(glm::dvec3(1, 2, -3)))};
  for (std::size_t k = 0; k < all.size(); ++k) {
    Table inputs = random_inputs(14 + k, 2);
    for (std::size_t i = 0; i < million; ++i) inputs.at(i, 1) = glm::vec4(all[k], 0);
    const Table got = run(warps::hemisphere, inputs);
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
  const auto r2 = column(got, [](const auto& o) { return std::min((o.x * o.x + o.y * o.y) / 4.0, 1.0); });
  const auto phi = column(got, turn_around_z);
  const auto time = column(got, [](const auto& o) { return 0.5 * (o.w - 1.0); });
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
    const auto along = [&](const glm::dvec3& area) {
      return std::clamp(glm::dot(area, n) / glm::dot(n, n), 0.0, 1.0);
    };
    const auto along1 =
        column(got, [&](const auto& p) { return along(glm::cross(glm::dvec3(p) - corner, e2)); });
    const auto along2 =
        column(got, [&](const auto& p) { return along(glm::cross(e1, glm::dvec3(p) - corner)); });
    expect_uniform_pairs("light " + std::to_string(number++), along1, along2);
  }
}

}  // namespace
}  // namespace shadertwin::samplers_test
