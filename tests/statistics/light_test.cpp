// Direct light of every strategy against closed forms, and how fast noise falls.
#include <array>
#include <cmath>

#include "tests/shadertoy/shapes.h"
#include "tests/statistics/floor.h"
#include "tests/statistics/statistics.h"

namespace shadertwin::light_test {
namespace {

SHADERTWIN_STATISTICS(Light);

TEST(QuadLightOracle, GivesTheTable) {
  const std::array<std::pair<Floor, double>, 3> rows = {
      {{{1, 1, 1, 1, 1}, .2394564705}, {{2, 2, 1, 1, 1}, .5541264240}, {{10, 5, 24.8, .7, 20}, .3504707896}}};
  for (const auto& [floor, expected] : rows) EXPECT_NEAR(closed_form(floor, 0, 0), expected, 1e-10);
}

TEST_P(Light, StrategiesGiveTheClosedForm) {
  constexpr std::size_t batches = 64;
  const std::vector<glm::dvec2> points = {{0, 0}, {0.7, 0.2}, {3, -2}};
  for (const Floor& floor : {Floor{1, 1, 1, 1, 1}, Floor{2, 2, 1, 1, 1}, Floor{10, 5, 24.8, .7, 20}})
    for (const char* strategy : {"0", "1", "2", "3"}) {
      Probe paths{.file = "paths.glsl", .inputs = 2, .outputs = 3, .defines = floor_defines(floor)};
      paths.defines.insert(paths.defines.end(), {{"SAMPLES", "512"}, {"LIGHT_STRATEGY", strategy}});
      Table inputs(points.size() * batches, 2);
      for (std::size_t i = 0; i < inputs.cases(); ++i) {
        const glm::dvec2 p = points[i / batches];
        const glm::dvec3 eye(p.x + 0.1, 0.5 * floor.height, p.y + 0.1);
        inputs.at(i, 0) = texel(eye, static_cast<double>(i % batches));
        inputs.at(i, 1) = texel(glm::normalize(glm::dvec3(p.x, 0, p.y) - eye));
      }
      const Table got = run(paths, inputs);
      for (std::size_t k = 0; k < points.size(); ++k) {
        std::vector<double> means;
        for (std::size_t b = 0; b < batches; ++b) {
          means.push_back(got.at(k * batches + b, 0).x);
          EXPECT_EQ(got.at(k * batches + b, 2).z, 0.0F);
        }
        const double expected = closed_form(floor, points[k].x, points[k].y);
        expect_mean("strategy " + std::string(strategy) + ", light " + glsl(floor.width) + " by " +
                        glsl(floor.depth) + " at " + glsl(floor.height) + ", point " + std::to_string(k),
                    means, expected, 2e-6 * expected);
      }
    }
}

// Root mean square of the relative error after so many samples, from many independent means.
double noise(const std::function<Table(const Probe&, const Table&)>& run, const Floor& floor,
             const char* kind, int samples) {
  constexpr std::size_t means = 2048;
  Probe probe{.file = "paths.glsl", .inputs = 2, .outputs = 3, .defines = floor_defines(floor)};
  probe.defines.insert(probe.defines.end(), {{"SAMPLES", std::to_string(samples)}, {"RANDOM_NUMBERS", kind}});
  Table inputs(means, 2);
  for (std::size_t i = 0; i < means; ++i) {
    inputs.at(i, 0) = texel({0.3, 0.5, 0.2}, 0.0);  // the case's number is the pixel: other numbers each
    inputs.at(i, 1) = texel({0, -1, 0});
  }
  const Table got = run(probe, inputs);
  const double expected = closed_form(floor, 0.3, 0.2);
  double sum = 0.0;
  for (std::size_t i = 0; i < means; ++i) {
    const double error = static_cast<double>(got.at(i, 0).x) / expected - 1.0;
    sum += error * error / means;
  }
  return std::sqrt(sum);
}

// A root mean square of 2,048 means is known to 1.6 % (somewhat more where they aren't normal); over a span
// of 256 times the samples that is 0.005 of the slope.
constexpr double slope_error = 0.03;

TEST_P(Light, NoiseFallsWithTheSquareRootOfTheSamplesAndReachesNoFloor) {
  const auto measure = [this](const char* kind, int samples) {
    return noise([this](const Probe& p, const Table& t) { return run(p, t); }, {1, 1, 1, 1, 1}, kind,
                 samples);
  };
  const double few = measure("0", 4);
  const double many = measure("0", 1024);
  EXPECT_NEAR(std::log(many / few) / std::log(1024.0 / 4.0), -0.5, slope_error);
  EXPECT_LE(many, 1.1 * few / 16.0);
  // Owen's points on a smooth integrand: at the least -0.6, and never worse than independent numbers.
  const double few_points = measure("1", 4);
  const double many_points = measure("1", 1024);
  EXPECT_LE(std::log(many_points / few_points) / std::log(1024.0 / 4.0), -0.6);
  EXPECT_LE(few_points, 1.15 * few);
  EXPECT_LE(many_points, 1.15 * many);
}

}  // namespace
}  // namespace shadertwin::light_test
