// Warps: lengths, and the corners of their domains. tests/statistics asks how they are spread.
#include <array>
#include <cmath>
#include <numbers>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/random.h"
#include "tests/shadertoy/warps.h"

namespace shadertwin::warps_test {
namespace {

class Warps : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Warps);

using std::numbers::pi;

const Probe turn{.file = "warps.glsl", .function = 3};

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

TEST_P(Warps, DiskFollowsItsDefinitionAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(warps::disk, inputs);
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

TEST_P(Warps, UnitVectorsHaveUnitLengthAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(warps::unit_vector, inputs);
  Bar bar("sampleUnitVector, length");
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    bar.near(length(got.at(i, 0)), 1.0, 4.0 * unit_roundoff,
             {{"u", inputs.at(i, 0).x}, {"v", inputs.at(i, 0).y}});
}

TEST_P(Warps, BallStaysInsideAndFiniteAtEveryCorner) {
  const Table inputs = grid_inputs();
  const Table got = run(warps::ball, inputs);
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

TEST_P(Warps, CosineHemisphereStaysOnItsSideForEveryNormalAndCorner) {
  const std::vector<glm::vec3> all = normals();
  Bar unit("sampleCosineHemisphere, length");
  Bar side("sampleCosineHemisphere, directions below the surface");
  Bar orthonormal("basisAround, orthonormality");
  for (const glm::vec3& normal : all) {
    Table inputs = grid_inputs(2);
    for (std::size_t i = 0; i < inputs.cases(); ++i) inputs.at(i, 1) = glm::vec4(normal, 0);
    const Table got = run(warps::hemisphere, inputs);
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
  const Table got = run(warps::hemisphere, inputs);
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
}  // namespace shadertwin::warps_test
