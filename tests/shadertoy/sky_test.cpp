// background(): the cubemap's texels where they stand, and their means where two or three of them meet.
#include <cmath>

#include "host/player/inputs.h"
#include "host/text/load.h"
#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::sky_test {
namespace {

class Sky : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Sky);

const Probe sky{.file = "sky.glsl"};
constexpr double bar = 1e-6;  // 3e-7 of the decoding, and the filter's own rounding

const Texture& forest() {
  static const Texture texture = [] {
    const Project project =
        load_project(std::filesystem::path(SHADERTWIN_SOURCE_DIR) / "tests/shadertoy" / sky.file,
                     {.settings = {.defines = {{"INPUTS", "1"}, {"OUTPUTS", "1"}}}});
    return load_texture(project.passes.back().inputs[1]);
  }();
  return texture;
}

// What stands at a direction whose longest component is 1 or -1, by OpenGL ES 3.0's table 3.21.
glm::dvec3 texel_at(const glm::dvec3& d) {
  const int axis = std::abs(d.x) == 1.0 ? 0 : std::abs(d.y) == 1.0 ? 1 : 2;
  const bool negative = d[axis] < 0.0;
  glm::dvec2 on_face(d.x, -d.y);
  if (axis == 0) on_face = {negative ? d.z : -d.z, -d.y};
  if (axis == 1) on_face = {d.x, negative ? -d.z : d.z};
  if (axis == 2) on_face.x = negative ? -d.x : d.x;
  const int size = forest().width;
  const auto place = [&](double x) { return static_cast<std::size_t>((x * 0.5 + 0.5) * size); };
  const auto face = static_cast<std::size_t>(2 * axis + (negative ? 1 : 0));
  const std::size_t texel =
      (face * static_cast<std::size_t>(size) + place(on_face.y)) * static_cast<std::size_t>(size) +
      place(on_face.x);
  const auto channel = [&](std::size_t c) {
    return std::to_integer<int>(forest().data[4 * texel + c]) / 255.0;
  };
  return {channel(0), channel(1), channel(2)};
}

double decoded(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// A direction, and texels that are equally far from it.
struct Case {
  glm::dvec3 direction;
  std::vector<glm::dvec3> around;
};

void expect_means(const char* fact, const std::vector<Case>& cases, const Table& got, const Table& inputs) {
  Bar error(fact);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& d : cases[i].around)
      mean += texel_at(d) / static_cast<double>(cases[i].around.size());
    for (int c = 0; c < 3; ++c)
      error.near(
          got.at(i, 0)[c], decoded(mean[c]), bar,
          {{"x", inputs.at(i, 0).x}, {"y", inputs.at(i, 0).y}, {"z", inputs.at(i, 0).z}, {"channel", c}});
  }
}

Table directions(const std::vector<Case>& cases) {
  Table inputs(cases.size(), 1);
  for (std::size_t i = 0; i < cases.size(); ++i) inputs.at(i, 0) = texel(cases[i].direction);
  return inputs;
}

// A centre of a texel on a face's side, as a coordinate of the direction: exact in a float.
double centre(int texel) {
  return (2.0 * texel + 1.0) / forest().width - 1.0;
}

// The direction with these components along an axis and the two that follow it.
glm::dvec3 along(int axis, double first, double second, double third) {
  glm::dvec3 d;
  d[axis] = first;
  d[(axis + 1) % 3] = second;
  d[(axis + 2) % 3] = third;
  return d;
}

TEST_P(Sky, ShowsEveryTexelAtItsCentre) {
  std::vector<Case> cases;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < forest().width; ++i) {
        for (int j = 0; j < forest().width; ++j) {
          const glm::dvec3 d = along(axis, side, centre(i), centre(j));
          cases.push_back({d, {d}});
        }
      }
    }
  }
  const Table inputs = directions(cases);
  expect_means("background at texels, absolute error", cases, run(sky, inputs), inputs);
}

TEST_P(Sky, IsTheMeanOfBothFacesOnTheirEdge) {
  const double inside = centre(forest().width - 1);
  std::vector<Case> cases;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        for (int i = 0; i < forest().width; ++i)
          cases.push_back({along(axis, centre(i), a, b),
                           {along(axis, centre(i), a * inside, b), along(axis, centre(i), a, b * inside)}});
      }
    }
  }
  const Table inputs = directions(cases);
  expect_means("background on edges, absolute error", cases, run(sky, inputs), inputs);
}

TEST_P(Sky, IsTheMeanOfThreeFacesInTheirCorner) {
  const double inside = centre(forest().width - 1);
  std::vector<Case> cases;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 d(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    Case& added = cases.emplace_back(Case{d, {}});
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 near = inside * d;
      near[axis] = d[axis];
      added.around.push_back(near);
    }
  }
  const Table inputs = directions(cases);
  expect_means("background in corners, absolute error", cases, run(sky, inputs), inputs);
}

}  // namespace
}  // namespace shadertwin::sky_test
