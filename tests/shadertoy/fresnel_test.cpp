// Fresnel and Schlick on both sides of a surface, and Beer-Lambert, against double and against tables.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/random.h"

namespace shadertwin::fresnel_test {
namespace {

class Fresnel : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Fresnel);
class BeerLambert : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(BeerLambert);

const Probe reflectance{.file = "fresnel.glsl", .function = 0};
const Probe absorption{.file = "fresnel.glsl", .function = 1};

double squared(double x) {
  return x * x;
}

// Born and Wolf, section 1.5.2: tangents and sines of the two angles, so that nothing is shared with the
// shader.
double exact(double cosine, double eta_i, double eta_t) {
  const double c = std::clamp(cosine, 0.0, 1.0);
  if (eta_i == eta_t) return 0.0;
  const double sin_t = eta_i / eta_t * std::sqrt((1.0 - c) * (1.0 + c));
  if (sin_t >= 1.0) return 1.0;
  if (c == 0.0) return 1.0;
  const double theta_i = std::acos(c);
  const double theta_t = std::asin(sin_t);
  if (theta_i < 1e-4) {
    // Both angles vanish together: F(0), whose next term is of fourth order.
    return squared((eta_i - eta_t) / (eta_i + eta_t));
  }
  return 0.5 * (squared(std::sin(theta_i - theta_t) / std::sin(theta_i + theta_t)) +
                squared(std::tan(theta_i - theta_t) / std::tan(theta_i + theta_t)));
}

double schlick(double cosine, double eta_i, double eta_t) {
  if (eta_i == eta_t) return 0.0;
  double c = std::clamp(cosine, 0.0, 1.0);
  const double r0 = squared((eta_i - eta_t) / (eta_i + eta_t));
  if (eta_i > eta_t) {
    const double sin2_t = squared(eta_i / eta_t) * (1.0 - c) * (1.0 + c);
    if (sin2_t >= 1.0) return 1.0;
    c = std::sqrt(1.0 - sin2_t);
  }
  return r0 + (1.0 - r0) * std::pow(1.0 - c, 5);
}

double degrees(double angle) {
  return angle * std::numbers::pi / 180.0;
}

struct Row {
  double cosine, eta_i, eta_t, expected;
};

Table rows_of(const std::vector<Row>& rows) {
  Table inputs(rows.size(), 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    inputs.at(i, 0) = glm::vec4(rows[i].cosine, rows[i].eta_i, rows[i].eta_t, 0);
  return inputs;
}

TEST_P(Fresnel, GlassReflectsWhatTheTablesSay) {
  const std::vector<Row> rows = {
      {1.0, 1.0, 1.5, .04},
      {std::cos(degrees(30)), 1.0, 1.5, .0415226260},
      {std::cos(degrees(45)), 1.0, 1.5, .0502399110},
      {std::cos(degrees(60)), 1.0, 1.5, .0891867128},
      {std::cos(degrees(75)), 1.0, 1.5, .2530605630},
      {std::cos(degrees(85)), 1.0, 1.5, .6127996453},
      {std::cos(degrees(89.9)), 1.0, 1.5, .9899118769},
      {1.0, 1.5, 1.0, .04},
      {std::cos(degrees(20)), 1.5, 1.0, .0417285182},
      {std::cos(degrees(30)), 1.5, 1.0, .0551901673},
      {std::cos(degrees(40)), 1.5, 1.0, .2452912043},
      {std::cos(degrees(41.8)), 1.5, 1.0, .8907719215},
      {std::cos(degrees(41.8104)), 1.5, 1.0, 1.0},
      {std::cos(std::atan(1.5)), 1.0, 1.5,
       0.5 * squared(1.25 / 3.25)},  // Brewster: only one polarisation is reflected
      {std::cos(std::atan(1.33)), 1.0, 1.33, 0.5 * squared(.7689 / 2.7689)}};
  const Table got = run(reflectance, rows_of(rows));
  Bar bar("fresnelDielectric, tables");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double slope =
        rows[i].expected > 0.5 && rows[i].eta_i > 1.0 ? 1e-3 : 5e-7;  // infinite at the critical angle
    bar.near(static_cast<double>(got.at(i, 0).x), rows[i].expected, slope,
             {{"cosine", rows[i].cosine}, {"etaI", rows[i].eta_i}});
  }
}

TEST_P(Fresnel, EdgesOfTheDomainAreClampedAndFinite) {
  std::vector<Row> rows;
  for (const double eta : {0.2, 1.0 / 1.5, 0.999999, 1.0, 1.000001, 1.1, 1.33, 1.5, 2.42, 5.0})
    for (const double c : {-2.0, -1.0, -1e-7, -0.0, 0.0, 1e-30, 1e-7, 0.5, 1.0, 1.0 + 1.2e-7, 2.0})
      rows.push_back({c, 1.0, eta, 0});
  const Table got = run(reflectance, rows_of(rows));
  Bar range("Fresnel, values outside [0, 1]");
  Bar grazing("Fresnel, cosine <= 0 reflects all");
  Bar none("Fresnel, equal indices reflect nothing");
  Bar normal("Fresnel, cosine >= 1 is normal incidence");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto f = static_cast<double>(got.at(i, 0)[j]);
      const Bar::Inputs where = {
          {"cosine", rows[i].cosine}, {"eta", rows[i].eta_t}, {"exact, schlick, knob", j}};
      range.holds(f >= 0.0 && f <= 1.0, f, 0.0, where);
      if (rows[i].eta_t == 1.0 && rows[i].cosine > 0.0) none.near(f, 0.0, 0.0, where);
      if (rows[i].eta_t != 1.0 && rows[i].cosine <= 0.0 && std::abs(rows[i].eta_t - 1.0) > 1e-3)
        grazing.near(f, 1.0, 1e-6, where);
      if (rows[i].cosine >= 1.0)
        normal.near(f, squared((1.0 - rows[i].eta_t) / (1.0 + rows[i].eta_t)), 2e-7, where);
    }
  }
}

// Cosines of all scales above 0 and below 1, indices of the whole domain, from either side.
Table random_inputs(std::uint64_t seed) {
  Random random(seed);
  Table inputs(million, 1);
  for (std::size_t i = 0; i < million; ++i) {
    const double kind = random.uniform();
    double c = random.uniform();
    if (kind < 0.25) c = random.log_uniform(1e-6, 1.0);
    if (kind > 0.75) c = 1.0 - random.log_uniform(1e-7, 1.0);
    const double eta = random.log_uniform(0.2, 5.0);
    inputs.at(i, 0) = glm::vec4(c, i % 2 ? 1.0 : eta, i % 2 ? eta : 1.0, 0);
  }
  return inputs;
}

TEST_P(Fresnel, ExactAgreesWithDouble) {
  const Table inputs = random_inputs(21);
  const Table got = run(reflectance, inputs);
  Bar entering("fresnelDielectric entering, absolute error");
  Bar leaving("fresnelDielectric leaving, absolute error");
  Bar critical("fresnelDielectric within 1e-3 of the critical angle, absolute error");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec4 x(inputs.at(i, 0));
    const auto f = static_cast<double>(got.at(i, 0).x);
    const double sin2_t = squared(x.y / x.z) * (1.0 - x.x) * (1.0 + x.x);
    const bool near_critical = std::abs(sin2_t - 1.0) <= 1e-3;
    Bar& bar = x.y < x.z ? entering : near_critical ? critical : leaving;
    const double allowed = x.y < x.z ? 5e-7 : near_critical ? 1e-3 : 2e-5;
    bar.near(f, exact(x.x, x.y, x.z), allowed, {{"cosine", x.x}, {"etaI", x.y}, {"etaT", x.z}});
  }
}

TEST_P(Fresnel, SchlickAgreesWithDouble) {
  const Table inputs = random_inputs(22);
  const Table got = run(reflectance, inputs);
  Bar bar("schlick entering, relative error");
  Bar leaving("schlick leaving, absolute error");
  Bar knob("fresnelReflectance, difference from the exact form");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec4 x(inputs.at(i, 0));
    const double expected = schlick(x.x, x.y, x.z);
    const Bar::Inputs where = {{"cosine", x.x}, {"etaI", x.y}, {"etaT", x.z}};
    // R0 itself is ill-conditioned where the indices meet: an input's own rounding is worth u / |etaI -
    // etaT|.
    const double conditioning = std::max(1.0, 1.0 / std::abs(x.y - x.z));
    if (x.y < x.z)
      bar.near(static_cast<double>(got.at(i, 0).y), expected, 8.0 * unit_roundoff * expected * conditioning,
               where);
    else
      leaving.near(static_cast<double>(got.at(i, 0).y), expected,
                   std::abs(squared(x.y / x.z) * (1.0 - x.x) * (1.0 + x.x) - 1.0) <= 1e-3 ? 5e-3 : 2e-5,
                   where);
    knob.near(static_cast<double>(got.at(i, 0).z), static_cast<double>(got.at(i, 0).x), 0.0, where);
  }
}

TEST_P(Fresnel, LightThatEntersAndLightThatLeavesReflectAlike) {
  // F(cos_i, eta) = F(cos_t, 1 / eta): both directions along one path.
  Random random(23);
  Table there(million, 1);
  Table back(million, 1);
  for (std::size_t i = 0; i < million; ++i) {
    const auto eta = static_cast<double>(static_cast<float>(random.uniform(1.01, 5.0)));
    const auto ci = static_cast<double>(static_cast<float>(random.uniform(0.01, 1.0)));
    const double ct = std::sqrt(1.0 - (1.0 - ci * ci) / (eta * eta));
    there.at(i, 0) = glm::vec4(ci, 1.0, eta, 0);
    back.at(i, 0) = glm::vec4(ct, eta, 1.0, 0);
  }
  const Table f_there = run(reflectance, there);
  const Table f_back = run(reflectance, back);
  Bar bar("fresnelDielectric, reciprocity");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec4 x(there.at(i, 0));
    // Rounding cos_t, and 1 - sin^2 in the shader, move cos_i by two times eta^2 cos_t^2 / cos_i units at
    // most; |F'| <= 2 (1 + eta^2) / (eta cos_t).
    const double ct = static_cast<double>(back.at(i, 0).x);
    const double allowed = 1e-6 + 4.0 * (1.0 + x.z * x.z) * unit_roundoff * x.z * ct / x.x;
    bar.near(static_cast<double>(f_there.at(i, 0).x), static_cast<double>(f_back.at(i, 0).x), allowed,
             {{"cosine", x.x}, {"eta", x.z}});
  }
}

TEST_P(Fresnel, HemisphericalMeansAreThoseOfTheLiterature) {
  // 2 integral F c dc, by the midpoint rule on a million cosines; means from outside and from inside.
  struct Case {
    double eta, outside, inside;
  };
  for (const Case& c : {Case{1.5, .09178, .59635}, Case{1.33, .06593, .47195}, Case{1.1, .02516, .19434}}) {
    Table inputs(million, 1);
    std::array<double, 2> sum{};
    for (int side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < million; ++i)
        inputs.at(i, 0) =
            glm::vec4((static_cast<double>(i) + 0.5) * 0x1p-20, side ? c.eta : 1.0, side ? 1.0 : c.eta, 0);
      const Table got = run(reflectance, inputs);
      for (std::size_t i = 0; i < million; ++i)
        sum[static_cast<std::size_t>(side)] +=
            2.0 * static_cast<double>(got.at(i, 0).x) * static_cast<double>(inputs.at(i, 0).x) * 0x1p-20;
    }
    EXPECT_NEAR(sum[0], c.outside, 6e-6) << "eta " << c.eta;
    EXPECT_NEAR(sum[1], c.inside, 6e-6) << "eta " << c.eta;
    EXPECT_NEAR(1.0 - (1.0 - sum[0]) / (c.eta * c.eta), sum[1], 2e-6) << "eta " << c.eta;
  }
}

TEST_P(Fresnel, TheReportsKnobIsSchlickWithTheIncidentCosine) {
  Probe report = reflectance;
  report.defines = {{"FRESNEL", "2"}};
  const std::vector<Row> rows = {{0.8, 1.0, 1.5, .04 + .96 * std::pow(.2, 5)},
                                 {0.8, 1.5, 1.0, .04 + .96 * std::pow(.2, 5)},
                                 {0.3, 1.5, 1.0, .04 + .96 * std::pow(.7, 5)}};
  const Table got = run(report, rows_of(rows));
  Bar bar("FRESNEL 2, absolute error");
  for (std::size_t i = 0; i < rows.size(); ++i)
    bar.near(static_cast<double>(got.at(i, 0).z), rows[i].expected, 2e-7,
             {{"cosine", rows[i].cosine}, {"etaI", rows[i].eta_i}});
}

TEST_P(BeerLambert, TablesOfAbsorptionHold) {
  const std::vector<glm::dvec4> rows = {{0, .5, 1, 5.6},  {0, .5, 1, 0},    {1e-30, 200, 1e4, 1},
                                        {3, 3, 3, 1e-30}, {.9, .9, 0, 1e6}, {20, 22, 85, 1}};
  Table inputs(rows.size(), 1);
  for (std::size_t i = 0; i < rows.size(); ++i) inputs.at(i, 0) = glm::vec4(rows[i]);
  const Table got = run(absorption, inputs);
  EXPECT_EQ(got.at(0, 0).x, 1.0F);
  EXPECT_NEAR(got.at(0, 0).y, .06081006, 2e-8);
  EXPECT_NEAR(got.at(0, 0).z, .003697864, 3e-9);
  Bar bar("transmittance, tables, relative error");
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int j = 0; j < 3; ++j) {
      const double depth = static_cast<double>(inputs.at(i, 0)[j]) * static_cast<double>(inputs.at(i, 0).w);
      const double expected = depth > 87.0 ? 0.0 : std::exp(-depth);
      bar.near(static_cast<double>(got.at(i, 0)[j]), expected,
               (8.0 + 2.0 * depth) * 2.0 * unit_roundoff * expected,
               {{"sigma", rows[i][j]}, {"d", rows[i].w}});
    }
}

TEST_P(BeerLambert, AgreesWithDoubleOverTheWholeRange) {
  Random random(24);
  Table inputs(million, 1);
  for (std::size_t i = 0; i < million; ++i)
    inputs.at(i, 0) = glm::vec4(random.log_uniform(1e-6, 1e2), random.uniform(0, 10), random.uniform(0, 1),
                                random.log_uniform(1e-3, 1e2));
  const Table got = run(absorption, inputs);
  Bar bar("transmittance, relative error");
  Bar black("transmittance beyond a depth of 104");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto sigma = static_cast<double>(inputs.at(i, 0)[j]);
      const auto d = static_cast<double>(inputs.at(i, 0).w);
      const double depth = sigma * d;
      const auto t = static_cast<double>(got.at(i, 0)[j]);
      // One ULP is at most two units of relative error.
      if (depth < 87.0)
        bar.near(t, std::exp(-depth), (8.0 + 2.0 * depth) * 2.0 * unit_roundoff * std::exp(-depth),
                 {{"sigma", sigma}, {"d", d}});
      if (depth > 104.0) black.near(t, 0.0, 0.0, {{"sigma", sigma}, {"d", d}});
    }
}

TEST_P(BeerLambert, TwoHalvesMakeAWhole) {
  Random random(25);
  Table whole(million, 1);
  Table first(million, 1);
  Table second(million, 1);
  for (std::size_t i = 0; i < million; ++i) {
    const auto a = static_cast<float>(random.uniform(0.0, 8.0));
    const auto b = static_cast<float>(random.uniform(0.0, 8.0));
    const glm::vec3 sigma(random.uniform(), random.uniform(), random.log_uniform(1e-4, 4));
    whole.at(i, 0) = glm::vec4(sigma, a + b);
    first.at(i, 0) = glm::vec4(sigma, a);
    second.at(i, 0) = glm::vec4(sigma, b);
  }
  const Table t = run(absorption, whole);
  const Table ta = run(absorption, first);
  const Table tb = run(absorption, second);
  Bar bar("transmittance, T(a + b) against T(a) T(b), relative");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const double depth = static_cast<double>(whole.at(i, 0)[j]) * static_cast<double>(whole.at(i, 0).w);
      const double expected = static_cast<double>(ta.at(i, 0)[j]) * static_cast<double>(tb.at(i, 0)[j]);
      bar.near(static_cast<double>(t.at(i, 0)[j]), expected, 4e-7 * (1.0 + depth) * expected,
               {{"depth", depth}});
    }
}

}  // namespace
}  // namespace shadertwin::fresnel_test
