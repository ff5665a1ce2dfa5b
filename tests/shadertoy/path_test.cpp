// Whole paths: furnaces of known radiance, roulette that changes no mean, and strategies that agree.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin {
namespace {

class RayColor : public OnEveryBackend {};
SHADERTWIN_ON_FIRST_BACKEND(RayColor);
class Paths : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Paths);

using Defines = std::vector<std::pair<std::string, std::string>>;

// Rays from a point in random directions, or given ones, each `batches` times.
struct Views {
  std::vector<std::pair<glm::dvec3, glm::dvec3>> rays;
  std::size_t batches = 64;
};

struct Outcome {
  std::vector<Mean> means;  // of green, a ray each
  double largest = 0.0, least = 1e30, bad = 0.0;
};

Outcome look(const std::function<Table(const Probe&, const Table&)>& run, const Views& views, int first,
             Defines defines) {
  const Probe probe{.file = "paths.glsl", .inputs = 2, .outputs = 3, .defines = std::move(defines)};
  Table inputs(views.rays.size() * views.batches, 2);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto& [from, towards] = views.rays[i / views.batches];
    inputs.at(i, 0) = texel(from, static_cast<double>(first) + static_cast<double>(i % views.batches));
    inputs.at(i, 1) = texel(glm::normalize(towards));
  }
  const Table got = run(probe, inputs);
  Outcome outcome;
  for (std::size_t k = 0; k < views.rays.size(); ++k) {
    std::vector<double> means;
    for (std::size_t b = 0; b < views.batches; ++b) {
      const std::size_t i = k * views.batches + b;
      means.push_back(got.at(i, 0).y);
      outcome.largest = std::max(outcome.largest, static_cast<double>(got.at(i, 2).x));
      outcome.least = std::min(outcome.least, static_cast<double>(got.at(i, 2).y));
      outcome.bad += got.at(i, 2).z;
    }
    outcome.means.push_back(mean_of(means));
  }
  return outcome;
}

Mean all(const std::vector<Mean>& means) {
  std::vector<double> values;
  for (const Mean& m : means) values.push_back(m.value);
  return mean_of(values);
}

Views from_inside(std::uint64_t seed, std::size_t rays, std::size_t batches) {
  Random random(seed);
  Views views{.rays = {}, .batches = batches};
  for (std::size_t i = 0; i < rays; ++i)
    views.rays.emplace_back(0.5 * random_direction(random), random_direction(random));
  return views;
}

#define RUN [this](const Probe& p, const Table& t) { return run(p, t); }

TEST_P(RayColor, ClosedFurnacesShineAsTheGeometricSeriesSays) {
  for (const auto& [rho, bounces] : {std::pair{"0.5", "200"}, {"0.8", "200"}, {"0.95", "400"}}) {
    const Outcome outcome =
        look(RUN, from_inside(131, 256, 8), 0,
             {{"ROOM", "1"}, {"SAMPLES", "8"}, {"ALBEDO", rho}, {"MAX_BOUNCES", bounces}});
    expect_mean("albedo " + std::string(rho) + ", with roulette", all(outcome.means),
                1.0 / (1.0 - std::stod(rho)), 1e-5);
    EXPECT_EQ(outcome.bad, 0.0);
  }
}

TEST_P(RayColor, WithoutRouletteEveryPathIsTheSeriesItself) {
  Bar bar("closed furnace without roulette, relative error of every path");
  for (const auto& [rho, bounces] : {std::pair{0.5, 64}, {0.8, 10}, {0.95, 32}, {1.0, 7}}) {
    const Outcome outcome = look(RUN, from_inside(132, 64, 1), 0,
                                 {{"ROOM", "1"},
                                  {"SAMPLES", "8"},
                                  {"ALBEDO", std::to_string(rho)},
                                  {"MAX_BOUNCES", std::to_string(bounces)},
                                  {"RR_START", "1000"}});
    const double expected = rho == 1.0 ? bounces : (1.0 - std::pow(rho, bounces)) / (1.0 - rho);
    for (const double value : {outcome.largest, outcome.least})
      bar.near(value, expected, 1e-5 * expected, {{"albedo", rho}, {"bounces", bounces}});
  }
}

TEST_P(RayColor, RouletteNeverGivesMoreThanItMay) {
  // Survivors are divided by their chance, which is at most 1 and at least the floor: a path carries no more
  // than the walls' radiance times the terms of the series over the chances.
  const Outcome outcome =
      look(RUN, from_inside(133, 64, 4), 0,
           {{"ROOM", "1"}, {"SAMPLES", "16"}, {"ALBEDO", "1.0"}, {"MAX_BOUNCES", "40"}, {"RR_START", "0"}});
  EXPECT_EQ(outcome.largest, 40.0) << "nothing is absorbed, so nothing may end a path";
  EXPECT_EQ(outcome.least, 40.0);
}

TEST_P(RayColor, APointLightInAHollowBallGivesRadianceOne) {
  const Outcome outcome =
      look(RUN, from_inside(134, 256, 1), 0,
           {{"ROOM", "2"}, {"SAMPLES", "4"}, {"ALBEDO", "0.5"}, {"MAX_BOUNCES", "48"}, {"RR_START", "1000"}});
  Bar bar("point light in a hollow ball, radiance of every path");
  bar.near(outcome.largest, 1.0, 1e-5, {{"albedo", 0.5}});
  bar.near(outcome.least, 1.0, 1e-5, {{"albedo", 0.5}});
}

TEST_P(RayColor, BallsThatKeepAllLightVanishInWhiteLight) {
  Random random(135);
  Views views;
  for (int i = 0; i < 64; ++i) {
    const glm::dvec3 d = random_direction(random);
    views.rays.emplace_back(0.95 * random.uniform() * random_across(random, d) - 3.0 * d, d);
  }
  struct Ball {
    const char* material;
    double slack;
    Defines more = {};
  };
  const Ball balls[] = {{"createDiffuseMaterial(vec3(1.0))", 1e-5},
                        {"createMetalMaterial(vec3(1.0), 0.0)", 1e-5},
                        {"createDielectricMaterial(vec3(0.0), 1.5, 0.0)", 1e-3},
                        {"createDielectricMaterial(vec3(0.0), 1.1, 0.1)", 1e-3},
                        {"createConductorMaterial(vec3(1.0), vec3(1.0), 0.5)", 1e-2},
                        // Weights above 1, and roulette at once: survival is certain, not more than that.
                        {"createConductorMaterial(vec3(1.0), vec3(1.0), 0.8)",
                         1e-2,
                         {{"SPECULAR_SAMPLING", "1"}, {"RR_START", "0"}}},
                        {"createPlasticMaterial(vec3(1.0), 0.3)", 1e-2}};
  for (const Ball& ball : balls) {
    Defines defines = {{"ROOM", "3"},
                       {"SAMPLES", "64"},
                       {"BACKGROUND", "4"},
                       {"BALL_MATERIAL", ball.material},
                       {"MAX_BOUNCES", "32"}};
    defines.insert(defines.end(), ball.more.begin(), ball.more.end());
    const Outcome outcome = look(RUN, views, 0, defines);
    expect_mean(ball.material, all(outcome.means), 1.0, ball.slack);
    EXPECT_LE(all(outcome.means).value, 1.0 + 5e-3) << ball.material;
    EXPECT_EQ(outcome.bad, 0.0) << ball.material;
    EXPECT_GE(outcome.least, 0.0) << ball.material;
  }
}

TEST_P(RayColor, StrategiesAndRouletteAgreeInTheCornellBox) {
  Random random(136);
  Views views{.rays = {}, .batches = 128};
  for (int i = 0; i < 24; ++i)
    views.rays.emplace_back(
        glm::dvec3(0, 3, 11),
        glm::dvec3(random.uniform(-3.5, 3.5), random.uniform(0.3, 5.5), -2) - glm::dvec3(0, 3, 11));
  const Defines common = {{"ROOM", "9"}, {"SAMPLES", "16"}, {"MAX_BOUNCES", "8"}};
  const auto with = [&](const Defines& more, int first) {
    Defines defines = common;
    defines.insert(defines.end(), more.begin(), more.end());
    return look(RUN, views, first, defines);
  };
  const Outcome reference = with({{"LIGHT_STRATEGY", "0"}}, 0);
  EXPECT_EQ(reference.bad, 0.0);
  const std::vector<std::pair<const char*, Defines>> others = {
      {"balance heuristic", {{"LIGHT_STRATEGY", "1"}}},
      {"surface only", {{"LIGHT_STRATEGY", "3"}}},
      {"light only", {{"LIGHT_STRATEGY", "2"}}},
      {"no roulette", {{"RR_START", "1000"}}},
      {"roulette from the first bounce", {{"RR_START", "0"}}},
      {"any normal", {{"SPECULAR_SAMPLING", "1"}}}};
  int first = 1000;
  for (const auto& [name, defines] : others) {
    const Outcome other = with(defines, first += 1000);
    EXPECT_EQ(other.bad, 0.0) << name;
    for (std::size_t k = 0; k < views.rays.size(); ++k)
      expect_same_mean(std::string(name) + ", ray " + std::to_string(k), reference.means[k], other.means[k]);
    expect_same_mean(
        std::string(name) + ", all rays",
        [&] {
          Mean sum;
          for (const Mean& m : reference.means) {
            sum.value += m.value;
            sum.sigma = std::hypot(sum.sigma, m.sigma);
          }
          return sum;
        }(),
        [&] {
          Mean sum;
          for (const Mean& m : other.means) {
            sum.value += m.value;
            sum.sigma = std::hypot(sum.sigma, m.sigma);
          }
          return sum;
        }());
  }
}

TEST_P(Paths, OfAFurnaceAndOfTheCornellBoxAreTheSameEverywhere) {
  const Outcome furnace = look(RUN, from_inside(137, 64, 8), 0,
                               {{"ROOM", "1"}, {"SAMPLES", "8"}, {"ALBEDO", "0.5"}, {"MAX_BOUNCES", "60"}});
  expect_mean("furnace", all(furnace.means), 2.0, 1e-5);
  Random random(138);
  Views views{.rays = {}, .batches = 8};
  for (int i = 0; i < 64; ++i)
    views.rays.emplace_back(
        glm::dvec3(0, 3, 11),
        glm::dvec3(random.uniform(-3.5, 3.5), random.uniform(0.3, 5.5), -2) - glm::dvec3(0, 3, 11));
  const Outcome box = look(RUN, views, 0, {{"ROOM", "9"}, {"SAMPLES", "4"}, {"MAX_BOUNCES", "8"}});
  EXPECT_EQ(box.bad, 0.0);
  EXPECT_GE(box.least, 0.0);
  EXPECT_GT(all(box.means).value, 0.1);
}

}  // namespace
}  // namespace shadertwin
