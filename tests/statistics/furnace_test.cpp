// White furnaces: no material gives back more light than it gets, and each gives back what its closed form or
// its quadrature says.
#include <cmath>

#include "tests/shadertoy/ggx.h"
#include "tests/statistics/statistics.h"

namespace shadertwin::furnace_test {
namespace {

SHADERTWIN_STATISTICS(Furnace);

enum Type { diffuse, metal, dielectric, conductor, plastic };
const std::vector<double> roughnesses = {0, .05, .1, .2, .3, .4, .5, .6, .7, .8, .9, 1};
const std::vector<double> cosines = {1, .9, .7, .5, .3, .2, .1, .05};
constexpr std::size_t batches = 64;
constexpr int samples = 1024;
constexpr double summing = 2e-5;  // what adding as many floats is off by

struct Setting {
  Type type;
  double roughness, cosine;
  glm::dvec3 color;
  double index = 1.5;
};

struct Result {
  Mean red;
  double goes_on = 0.0;
  double largest = 0.0, least = 1e30;
};

using Defines = std::vector<std::pair<std::string, std::string>>;

std::vector<Result> measure(const std::function<Table(const Probe&, const Table&)>& run,
                            const std::vector<Setting>& settings, Defines defines) {
  defines.emplace_back("SAMPLES", std::to_string(samples));
  const Probe probe{.file = "furnace.glsl", .inputs = 2, .outputs = 3, .defines = defines};
  Table inputs(settings.size() * batches, 2);
  for (std::size_t s = 0; s < settings.size(); ++s)
    for (std::size_t b = 0; b < batches; ++b) {
      const Setting& setting = settings[s];
      inputs.at(s * batches + b, 0) = glm::vec4(setting.type, setting.roughness, setting.cosine, b);
      inputs.at(s * batches + b, 1) = glm::vec4(setting.color, setting.index);
    }
  const Table got = run(probe, inputs);
  std::vector<Result> results(settings.size());
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::vector<double> means;
    for (std::size_t b = 0; b < batches; ++b) {
      const std::size_t i = s * batches + b;
      means.push_back(got.at(i, 0).x);
      results[s].goes_on += static_cast<double>(got.at(i, 2).x) / batches;
      results[s].largest = std::max(results[s].largest, static_cast<double>(got.at(i, 2).y));
      results[s].least = std::min(results[s].least, static_cast<double>(got.at(i, 2).z));
    }
    results[s].red = mean_of(means);  // of batches: the weights of single samples may be heavy-tailed
  }
  return results;
}

std::string name_of(const Setting& s) {
  return "roughness " + std::to_string(s.roughness) + ", cosine " + std::to_string(s.cosine) + ", color " +
         std::to_string(s.color.x);
}

const Defines single_scattering = {{"ENERGY_COMPENSATION", "0"}, {"FRESNEL", "1"}};

TEST(FurnaceOracle, QuadratureGivesTheTables) {
  const auto one = [](double) { return 1.0; };
  struct Row {
    double roughness, cosine, albedo, slack;
  };
  for (const Row& row :
       {Row{.3, 1, .9906, 5e-4}, Row{.3, .5, .9751, 5e-4}, Row{.5, .2, .8482, 1e-4}, Row{.7, .05, .914, 1e-3},
        Row{1, 1, 1 - std::log(2.0), 1e-6}, Row{1, .5, .4507, 1e-4}})
    EXPECT_NEAR(ggx::albedo(row.cosine, row.roughness * row.roughness, one), row.albedo, row.slack)
        << row.roughness << " " << row.cosine;
}

TEST_P(Furnace, RoughMetalsLoseWhatSingleScatteringLoses) {
  std::vector<Setting> settings;
  for (const double r : roughnesses)
    for (const double mu : cosines) settings.push_back({conductor, r, mu, glm::dvec3(1)});
  const auto results =
      measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, single_scattering);
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const double alpha = settings[s].roughness * settings[s].roughness;
    const double expected =
        alpha < 1e-3 ? 1.0 : ggx::albedo(settings[s].cosine, alpha, [](double) { return 1.0; });
    expect_mean("metal, " + name_of(settings[s]), results[s].red, expected, 5e-4);
    expect_at_most("metal, " + name_of(settings[s]), results[s].red, 1.0);
    EXPECT_LE(results[s].largest, 1.0 + 4e-6)
        << "weights of visible normals are at most 1, " << name_of(settings[s]);
  }
}

TEST_P(Furnace, AnyNormalAndVisibleNormalsGiveTheSameMean) {
  std::vector<Setting> settings;
  for (const double r : {.3, .5, .8, 1.0})
    for (const double mu : {1.0, .5, .2}) settings.push_back({conductor, r, mu, glm::dvec3(1)});
  Defines defines = single_scattering;
  defines.emplace_back("SPECULAR_SAMPLING", "1");
  const auto results =
      measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, defines);
  for (std::size_t s = 0; s < settings.size(); ++s)
    expect_mean("any normal, " + name_of(settings[s]), results[s].red,
                ggx::albedo(settings[s].cosine, settings[s].roughness * settings[s].roughness,
                            [](double) { return 1.0; }),
                5e-4);
}

TEST_P(Furnace, CompensatedMetalsKeepAllLight) {
  std::vector<double> with_places_between = roughnesses;  // where the table is furthest off
  with_places_between.insert(with_places_between.end(), {.1129, .2258, .2903, .33, .3871, .9677});
  std::vector<Setting> settings;
  for (const double r : with_places_between)
    for (const double mu : cosines) settings.push_back({conductor, r, mu, glm::dvec3(1)});
  const auto results =
      measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {{"FRESNEL", "1"}});
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const Mean& mean = results[s].red;
    expect_at_most("compensated metal, " + name_of(settings[s]), mean, 1.001);
    if (settings[s].cosine < 0.1) continue;
    expect_at_least("compensated metal, " + name_of(settings[s]), mean, 0.995);
  }
}

TEST_P(Furnace, PlasticNeverGivesMoreThanItGets) {
  std::vector<Setting> settings;
  for (const double rho : {0.0, 0.5, 1.0})
    for (const double r : {.05, .1, .3, .5, .7, 1.0})
      for (const double mu : {1.0, .7, .5, .2, .05, .02})
        settings.push_back({plastic, r, mu, glm::dvec3(rho)});
  for (const char* under : {"0", "1"}) {
    const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings,
                                 {{"PLASTIC_DIFFUSE", under}});
    for (std::size_t s = 0; s < settings.size(); ++s) {
      const Mean& mean = results[s].red;
      expect_at_most("plastic, PLASTIC_DIFFUSE " + std::string(under) + ", " + name_of(settings[s]), mean,
                     1.0);
      EXPECT_GE(mean.value, 0.0) << name_of(settings[s]);
    }
  }
}

// Reflectance of a dielectric of index 1.5 from outside.
double glass(double c) {
  const double s2 = (1.0 - c * c) / 2.25;
  const double t = std::sqrt(1.0 - s2);
  const double rs = (c - 1.5 * t) / (c + 1.5 * t);
  const double rp = (1.5 * c - t) / (1.5 * c + t);
  return 0.5 * (rs * rs + rp * rp);
}

TEST_P(Furnace, BlackPlasticIsItsGloss) {
  std::vector<Setting> settings;
  for (const double r : {.1, .3, .5, .7, 1.0})
    for (const double mu : {1.0, .5, .2, .05}) settings.push_back({plastic, r, mu, glm::dvec3(0)});
  const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {});
  for (std::size_t s = 0; s < settings.size(); ++s)
    expect_mean("gloss, " + name_of(settings[s]), results[s].red,
                ggx::albedo(settings[s].cosine, settings[s].roughness * settings[s].roughness, glass), 2e-4);
}

TEST_P(Furnace, WhitePlasticKeepsItsLight) {
  // What enters below the gloss comes out again, but for the fit of the table.
  std::vector<Setting> settings;
  for (const double r : {.1, .3, .5, .7, 1.0})
    for (const double mu : {1.0, .7, .5, .3}) settings.push_back({plastic, r, mu, glm::dvec3(1)});
  const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {});
  for (std::size_t s = 0; s < settings.size(); ++s)
    expect_mean("white plastic, " + name_of(settings[s]), results[s].red, 1.0, 5e-3);
}

TEST_P(Furnace, DiffuseGivesItsAlbedo) {
  std::vector<Setting> settings;
  for (const double mu : cosines) settings.push_back({diffuse, 1, mu, glm::dvec3(0.7)});
  const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {});
  for (std::size_t s = 0; s < settings.size(); ++s)
    expect_mean("diffuse, " + name_of(settings[s]), results[s].red, 0.7, summing);
  // The report's weight, under its knob: two thirds of it.
  const auto report = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings,
                              {{"SEED_ATTENUATION", "1"}});
  for (std::size_t s = 0; s < settings.size(); ++s)
    expect_mean("the report's diffuse, " + name_of(settings[s]), report[s].red, 0.7 * 2.0 / 3.0, summing);
}

TEST_P(Furnace, ClearGlassCarriesAllLightOnEveryPath) {
  std::vector<Setting> settings;
  for (const double r : {0.0, 0.1, 0.5, 1.0})
    for (const double mu : cosines) settings.push_back({dielectric, r, mu, glm::dvec3(1), 1.33});
  Bar bar("clear glass, throughput of every path");
  // probeMaterial passes an absorption of 1: from outside there is no way through glass yet.
  const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {});
  for (std::size_t s = 0; s < settings.size(); ++s) {
    bar.near(results[s].largest, 1.0, 0.0,
             {{"roughness", settings[s].roughness}, {"cosine", settings[s].cosine}});
    bar.near(results[s].least, 1.0, 0.0,
             {{"roughness", settings[s].roughness}, {"cosine", settings[s].cosine}});
  }
}

TEST_P(Furnace, FuzzyMirrorsLoseWhatFallsBelowTheSurface) {
  // The part of a ball of radius r around the mirror direction's tip that is below the plane.
  std::vector<Setting> settings;
  for (const auto& [r, mu] : {std::pair{1.0, .5}, {1.0, .2}, {.5, .2}, {1.0, .05}, {.3, .5}, {0.0, .05}})
    settings.push_back({metal, r, mu, glm::dvec3(0.9)});
  const auto results = measure([this](const Probe& p, const Table& t) { return run(p, t); }, settings, {});
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const double part = settings[s].roughness > 0.0 ? settings[s].cosine / settings[s].roughness : 1.0;
    const double below = part < 1.0 ? (1.0 - part) * (1.0 - part) * (2.0 + part) / 4.0 : 0.0;
    expect_mean("fuzzy mirror, " + name_of(settings[s]), results[s].red, 0.9 * (1.0 - below), summing);
  }
}

}  // namespace
}  // namespace shadertwin::furnace_test
