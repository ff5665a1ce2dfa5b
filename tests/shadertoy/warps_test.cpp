// Warps: densities against closed distribution functions, lengths, and the corners of their domains.
#include <array>
#include <cmath>
#include <numbers>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/statistics.h"

namespace shadertwin {
namespace {

class Warps : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Warps);

using std::numbers::pi;

constexpr std::size_t million = std::size_t{1} << 20;
const Probe disk{.file = "warps.glsl", .function = 0};
const Probe unit_vector{.file = "warps.glsl", .function = 1};
const Probe ball{.file = "warps.glsl", .function = 2};
const Probe turn{.file = "warps.glsl", .function = 3};
const Probe hemisphere{.file = "hemisphere.glsl", .inputs = 2, .outputs = 3};

Table random_inputs(std::uint64_t seed, int size = 1) {
  Random random(seed);
  Table inputs(million, size);
  for (std::size_t i = 0; i < million; ++i)
    inputs.at(i, 0) = glm::vec4(random.uniform(), random.uniform(), random.uniform(), random.uniform());
  return inputs;
}

// 2^16 points of the unit square, its corners, sides and quarters among them.
Table grid_inputs(int size = 1) {
  Table inputs(std::size_t{1} << 16, size);
  constexpr double last = 1.0 - 0x1p-24;
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto coordinate = [](std::size_t k) { return k == 255 ? last : static_cast<double>(k) / 256.0; };
    inputs.at(i, 0) = glm::vec4(coordinate(i % 256), coordinate(i / 256), coordinate((i * 7) % 256), 0.0);
  }
  return inputs;
}

double length(const glm::vec4& v) {
  return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

// Angle over a turn, in [0, 1).
double turn_of(double y, double x) {
  const double t = std::atan2(y, x) / (2.0 * pi);
  return std::min(t < 0.0 ? t + 1.0 : t, 1.0 - 1e-12);
}

TEST_P(Warps, SineAndCosineOfATurnAreWithinTwoUnits) {
  Table inputs(million + 9, 1);
  for (std::size_t i = 0; i <= million; ++i)
    inputs.at(i, 0).x = static_cast<float>(static_cast<double>(i) * 0x1p-20);
  for (std::size_t k = 0; k < 8; ++k)
    inputs.at(million + 1 + k, 0).x = std::nextafter(static_cast<float>(k + 1) / 8.0F, 0.0F);
  const Table got = run(turn, inputs);
  Bar sine("sinCosTurn, absolute error of the sine");
  Bar cosine("sinCosTurn, absolute error of the cosine");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto u = static_cast<double>(inputs.at(i, 0).x);
    sine.near(static_cast<double>(got.at(i, 0).x), std::sin(2.0 * pi * u), 2e-7, {{"u", u}});
    cosine.near(static_cast<double>(got.at(i, 0).y), std::cos(2.0 * pi * u), 2e-7, {{"u", u}});
  }
}

TEST_P(Warps, DiskIsUniform) {
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

TEST_P(Warps, DiskFollowsItsDefinitionAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(disk, inputs);
  Bar bar("sampleDisk, absolute error");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto u = static_cast<double>(inputs.at(i, 0).x);
    const auto v = static_cast<double>(inputs.at(i, 0).y);
    bar.near(static_cast<double>(got.at(i, 0).x), std::sqrt(u) * std::cos(2.0 * pi * v), 4e-7,
             {{"u", u}, {"v", v}});
    bar.near(static_cast<double>(got.at(i, 0).y), std::sqrt(u) * std::sin(2.0 * pi * v), 4e-7,
             {{"u", u}, {"v", v}});
  }
}

TEST_P(Warps, UnitVectorsAreUniformOnTheSphere) {
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

TEST_P(Warps, UnitVectorsHaveUnitLengthAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(unit_vector, inputs);
  Bar bar("sampleUnitVector, length");
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    bar.near(length(got.at(i, 0)), 1.0, 4.0 * unit_roundoff,
             {{"u", inputs.at(i, 0).x}, {"v", inputs.at(i, 0).y}});
}

TEST_P(Warps, BallIsUniform) {
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

TEST_P(Warps, BallStaysInsideAndFiniteAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(ball, inputs);
  Bar bar("sampleBall, radius");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto u = static_cast<double>(inputs.at(i, 0).z);
    bar.near(length(got.at(i, 0)), std::cbrt(u), 1e-6, {{"u", u}});
  }
}

// Axes, the diagonal, and both sides of the place where the basis switches its formula.
std::vector<glm::vec3> normals() {
  std::vector<glm::vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  all.push_back(glm::vec3(glm::normalize(glm::dvec3(1, 2, -3))));
  all.push_back(glm::vec3(glm::normalize(glm::dvec3(1e-4, -2e-4, -1))));
  all.push_back(glm::vec3(glm::normalize(glm::dvec3(-1, 1, 1e-7))));
  all.push_back(glm::vec3(glm::normalize(glm::dvec3(-1, 1, -1e-7))));
  all.push_back({1, 0, -0.0F});
  return all;
}

TEST_P(Warps, CosineHemisphereHasTheDensityOfTheCosine) {
  const std::vector<glm::vec3> all = normals();
  for (const std::size_t k : {std::size_t{4}, std::size_t{5}, std::size_t{6}}) {
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

TEST_P(Warps, CosineHemisphereStaysOnItsSideForEveryNormalAndCorner) {
  const std::vector<glm::vec3> all = normals();
  Bar unit("sampleCosineHemisphere, length");
  Bar side("sampleCosineHemisphere, directions below the surface");
  Bar orthonormal("basisAround, orthonormality");
  for (const glm::vec3& normal : all) {
    Table inputs = grid_inputs(2);
    for (std::size_t i = 0; i < inputs.cases(); ++i) inputs.at(i, 1) = glm::vec4(normal, 0);
    const Table got = run(hemisphere, inputs);
    const glm::dvec3 n(normal);
    for (std::size_t i = 0; i < inputs.cases(); ++i) {
      const Bar::Inputs where = {
          {"u", inputs.at(i, 0).x}, {"v", inputs.at(i, 0).y}, {"n.x", n.x}, {"n.y", n.y}, {"n.z", n.z}};
      const glm::dvec3 d(got.at(i, 0));
      unit.near(glm::length(d), 1.0, 4.0 * unit_roundoff, where);
      // A corner lies in the surface itself, where the sign of the dot product is rounding.
      side.holds(glm::dot(d, n) >= -unit_roundoff, glm::dot(d, n), 0.0, where);
    }
    const glm::dvec3 t(got.at(0, 1));
    const glm::dvec3 s(got.at(0, 2));
    const Bar::Inputs at = {{"n.x", n.x}, {"n.y", n.y}, {"n.z", n.z}};
    orthonormal.near(glm::length(t), 1.0, 4e-7, at);
    orthonormal.near(glm::length(s), 1.0, 4e-7, at);
    orthonormal.near(glm::dot(t, s), 0.0, 4e-7, at);
    orthonormal.near(glm::dot(t, n), 0.0, 4e-7, at);
    orthonormal.near(glm::dot(s, n), 0.0, 4e-7, at);
    orthonormal.near(glm::dot(glm::cross(t, s), n), 1.0, 4e-7, at);
  }
}

TEST_P(Warps, BasisIsOrthonormalAndRightHandedForRandomNormals) {
  Random random(15);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    const double scale = random.log_uniform(1e-8, 1.0);  // close to the axes as well
    const glm::dvec3 v(random.uniform(-1, 1), scale * random.uniform(-1, 1),
                       random.sign() * random.log_uniform(1e-8, 1.0));
    inputs.at(i, 1) = glm::vec4(glm::normalize(v), 0);
  }
  const Table got = run(hemisphere, inputs);
  Bar bar("basisAround, orthonormality of random normals");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 n(inputs.at(i, 1));
    const glm::dvec3 t(got.at(i, 1));
    const glm::dvec3 s(got.at(i, 2));
    const Bar::Inputs at = {{"n.x", n.x}, {"n.y", n.y}, {"n.z", n.z}};
    bar.near(glm::length(t), 1.0, 4e-7, at);
    bar.near(glm::dot(t, s), 0.0, 4e-7, at);
    bar.near(glm::dot(t, n), 0.0, 4e-7, at);
    bar.near(glm::dot(glm::cross(t, s), n), 1.0, 5e-7, at);
  }
}

}  // namespace
}  // namespace shadertwin
