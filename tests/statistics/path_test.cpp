// Whole paths: furnaces of known radiance, roulette that changes no mean, and strategies that agree.
#include <cmath>

#include "tests/shadertoy/shapes.h"
#include "tests/statistics/statistics.h"

namespace shadertwin::path_test {
namespace {

SHADERTWIN_STATISTICS(RayColor);

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
  Random random = draw(seed);
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

TEST_P(RayColor, APointLightInAHollowBallFallsWithTheSquareOfItsRadius) {
  Bar bar("point light in a hollow ball, radiance of every path");
  for (const double radius : {1.0, 2.0, 8.0}) {
    const Outcome outcome = look(RUN, from_inside(134, 256, 1), 0,
                                 {{"ROOM", "2"},
                                  {"SAMPLES", "4"},
                                  {"ALBEDO", "0.5"},
                                  {"BALL_RADIUS", std::to_string(radius)},
                                  {"MAX_BOUNCES", "48"},
                                  {"RR_START", "1000"}});
    const double expected = 1.0 / (radius * radius);
    for (const double value : {outcome.largest, outcome.least})
      bar.near(value, expected, 1e-5 * expected, {{"albedo", 0.5}, {"radius", radius}});
  }
}

// One of several lights, weighed by how seldom it is picked, gives what all of them give.
TEST_P(RayColor, APickedPointLightStandsForAll) {
  for (const char* pick : {"0", "1"}) {
    const Outcome outcome = look(RUN, from_inside(137, 256, 64), 0,
                                 {{"ROOM", "2"},
                                  {"POINT_LIGHTS", "3"},
                                  {"POINT_LIGHT_PICK", pick},
                                  {"SAMPLES", "16"},
                                  {"ALBEDO", "0.5"},
                                  {"MAX_BOUNCES", "48"},
                                  {"RR_START", "1000"}});
    expect_mean("three point lights in a hollow ball, POINT_LIGHT_PICK=" + std::string(pick),
                all(outcome.means), 1.0, 1e-5);
  }
}

TEST_P(RayColor, BallsThatKeepAllLightVanishInWhiteLight) {
  Random random = draw(135);
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

// A path ends with the first draw that is not below its survival, which its throughput and the threshold
// give. In a room whose walls shine with radiance 1 and reflect rho, what it has gathered by then tells how
// long it was.
TEST_P(RayColor, RouletteLetsPathsLiveAsOftenAsItSays) {
  constexpr std::size_t count = 1 << 16;
  constexpr std::size_t bounces = 400;
  for (const auto& [threshold, rho] : {std::pair{"1.0", "0.1"},
                                       {"1.0", "0.3"},
                                       {"1.0", "0.5"},
                                       {"1.0", "0.8"},
                                       {"1.0", "0.95"},
                                       {"0.25", "0.1"},
                                       {"0.25", "0.7"},
                                       {"0.125", "0.9"}}) {
    const Probe probe{.file = "paths.glsl",
                      .inputs = 2,
                      .outputs = 3,
                      .defines = {{"ROOM", "1"},
                                  {"SAMPLES", "1"},
                                  {"ALBEDO", rho},
                                  {"MAX_BOUNCES", std::to_string(bounces)},
                                  {"RR_START", "0"},
                                  {"RR_THRESHOLD", threshold},
                                  {"RR_FLOOR", "0.0"}}};
    Random random = draw(139);
    Table inputs(count, 2);
    for (std::size_t i = 0; i < count; ++i) {
      inputs.at(i, 0) = texel(0.5 * random_direction(random));
      inputs.at(i, 1) = texel(random_direction(random));
    }
    const Table got = run(probe, inputs);

    std::vector<double> expected(bounces);
    std::vector<double> between(bounces);  // what paths of k and of k + 1 surfaces gather, half of each
    double alive = count;
    double throughput = 1.0;
    double gathered = 0.0;
    for (std::size_t k = 0; k < bounces; ++k) {
      gathered += throughput;
      throughput *= std::stod(rho);
      const double survival = std::min(throughput / std::stod(threshold), 1.0);
      expected[k] = alive * (1.0 - survival);
      alive *= survival;
      throughput /= survival;
      between[k] = gathered + 0.5 * throughput;
    }
    std::vector<double> counts(bounces);
    for (std::size_t i = 0; i < count; ++i) {
      const auto length =
          std::ranges::upper_bound(between, static_cast<double>(got.at(i, 0).y)) - between.begin();
      counts[std::min(static_cast<std::size_t>(length), bounces - 1)] += 1.0;
    }
    expect_plausible("lengths of paths, albedo " + std::string(rho) + ", threshold " + threshold,
                     chi_square_p(counts, expected));
  }
}

// A picture of the Cornell box in tiles, as Jung, Hanika and Dachsbacher 2020 compare renderers ("Detecting
// Bias in Monte Carlo Renderers using Welch's t-test", JCGT 9(2)): a fault shows in the tiles that it
// touches, and Fisher's sum finds one that is spread thinly over all.
constexpr std::size_t tiles_across = 6;
constexpr std::size_t tiles_down = 5;
constexpr std::size_t tile = 4;  // pixels across and down
constexpr std::size_t batches = 32;

std::vector<Mean> tiles(const std::function<Table(const Probe&, const Table&)>& run, int first,
                        Defines defines) {
  defines.insert(defines.end(), {{"ROOM", "9"}, {"SAMPLES", "6"}, {"MAX_BOUNCES", "8"}});
  const Probe probe{.file = "paths.glsl", .inputs = 2, .outputs = 3, .defines = std::move(defines)};
  constexpr std::size_t count = tiles_across * tiles_down * tile * tile;
  Table inputs(count * batches, 2);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const std::size_t pixel = i / batches % (tile * tile);
    const std::size_t t = i / batches / (tile * tile);
    const auto x = static_cast<double>(t % tiles_across * tile + pixel % tile) + 0.5;
    const auto y = static_cast<double>(t / tiles_across * tile + pixel / tile) + 0.5;
    const glm::dvec3 eye(0, 3, 11);
    const glm::dvec3 target(7.0 * (x / (tiles_across * tile) - 0.5), 0.3 + 5.2 * y / (tiles_down * tile), -2);
    inputs.at(i, 0) = texel(eye, static_cast<double>(first) + static_cast<double>(i % batches));
    inputs.at(i, 1) = texel(glm::normalize(target - eye));
  }
  const Table got = run(probe, inputs);
  std::vector<Mean> means;
  for (std::size_t t = 0; t < tiles_across * tiles_down; ++t) {
    std::vector<double> batch(batches);
    for (std::size_t i = t * tile * tile * batches; i < (t + 1) * tile * tile * batches; ++i) {
      const glm::dvec3 c(got.at(i, 0));
      batch[i % batches] += (c.r + c.g + c.b) / (3.0 * tile * tile);
      EXPECT_EQ(got.at(i, 2).z, 0.0F) << "a sample that is no number";
    }
    means.push_back(mean_of(batch));
  }
  return means;
}

void expect_same_tiles(const std::string& what, const std::vector<Mean>& a, const std::vector<Mean>& b) {
  std::vector<double> p;
  for (std::size_t t = 0; t < a.size(); ++t) {
    p.push_back(welch_p(a[t], b[t]));
    expect_plausible(what + ", tile " + std::to_string(t) + ": " + std::to_string(a[t].value) + " against " +
                         std::to_string(b[t].value),
                     p.back());
  }
  expect_plausible(what + ", all tiles", fisher(p));
}

TEST_P(RayColor, LightStrategiesAgreeInEveryTile) {
  const auto reference = tiles(RUN, 0, {{"LIGHT_STRATEGY", "0"}});
  int first = 0;
  for (const auto& [name, defines] : std::initializer_list<std::pair<const char*, Defines>>{
           {"balance heuristic", {{"LIGHT_STRATEGY", "1"}}},
           {"light only", {{"LIGHT_STRATEGY", "2"}}},
           {"surface only", {{"LIGHT_STRATEGY", "3"}}},
           {"any normal", {{"SPECULAR_SAMPLING", "1"}}}})
    expect_same_tiles(name, reference, tiles(RUN, first += 1000, defines));
}

TEST_P(RayColor, RouletteAgreesInEveryTile) {
  const auto reference = tiles(RUN, 10000, {{"RR_START", "1000"}});
  int first = 10000;
  for (const auto& [name, defines] : std::initializer_list<std::pair<const char*, Defines>>{
           {"roulette", {}},
           {"roulette from the first bounce", {{"RR_START", "0"}}},
           {"roulette of every path that lost light", {{"RR_START", "0"}, {"RR_THRESHOLD", "1.0"}}},
           {"roulette without a floor", {{"RR_START", "0"}, {"RR_FLOOR", "0.001"}}}})
    expect_same_tiles(name, reference, tiles(RUN, first += 1000, defines));
}

}  // namespace
}  // namespace shadertwin::path_test
