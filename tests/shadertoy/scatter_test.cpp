// scatter and evaluateBsdf of every material: perfect directions, fuzzy ones, densities, reciprocity, and
// extremes.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/ggx.h"
#include "tests/shadertoy/scattering.h"

namespace shadertwin::scatter_test {
namespace {

class Scatter : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Scatter);

using std::numbers::pi;
constexpr double u = unit_roundoff;
using namespace scattering;  // NOLINT(google-build-using-namespace)

TEST_P(Scatter, MirrorsReflect) {
  Random random(101);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    cases.push_back(arriving(random, i % 2 ? metal : conductor, 1e-6));
    cases.back().roughness = i % 2 ? 0.0 : random.uniform(0.0, 0.031);
    cases.back().extra = glm::dvec3(1);
    if (i % 3 == 0)
      cases.back().normal = -cases.back().normal;  // a surface does not ask which side is its front
  }
  const Table inputs = table_of(cases);
  const Table got = run(probe(0), inputs);
  Bar mirror("mirror direction, distance from 2 (n.v) n - v");
  Bar frame("mirror direction of a smooth conductor, through its frame");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 d = vec(inputs.at(i, 0));
    const glm::dvec3 n = glm::normalize(vec(inputs.at(i, 1)));
    const double error = glm::distance(vec(got.at(i, 1)), glm::normalize(d - 2.0 * glm::dot(d, n) * n));
    (i % 2 ? mirror : frame).near(error, 0.0, (i % 2 ? 8.0 : 12.0) * u, {{"case", i}});
  }
}

TEST_P(Scatter, GlassRefractsAsSnellSaysAndReflectsBeyondTheCriticalAngle) {
  Random random(102);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    Case c = arriving(random, dielectric, 1e-6);
    c.roughness = 0.0;
    c.index = random.uniform(1.0, 3.0);
    c.xi.z = 1.0 - 0x1p-24;  // refracts whenever it can
    if (i % 2) c.normal = -c.normal;
    cases.push_back(c);
  }
  const Table inputs = table_of(cases);
  const Table got = run(probe(0), inputs);
  Bar snell("refraction, ni sin i - nt sin t");
  Bar plane("refraction, distance from the plane of incidence");
  Bar unit("glass, length of the direction");
  Bar side("glass, rays on the wrong side");
  Bar origin("glass, origins on the wrong side");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 d = vec(inputs.at(i, 0));
    const glm::dvec3 n = glm::normalize(vec(inputs.at(i, 1)));
    const glm::dvec3 t = vec(got.at(i, 1));
    const bool leaves = glm::dot(d, n) > 0.0;
    const double index = inputs.at(i, 2).w;
    const double etaI = leaves ? index : 1.0;
    const double etaT = leaves ? 1.0 : index;
    const glm::dvec3 across = d - glm::dot(d, n) * n;
    const double sine = etaI / etaT * glm::length(across) / glm::length(d);
    const Bar::Inputs where = {{"case", i}, {"index", index}, {"leaves", leaves}, {"sine", sine}};
    unit.near(glm::length(t), 1.0, 4.0 * u, where);
    if (std::abs(sine - 1.0) < 1e-5) continue;  // critical to within rounding
    // A share of 2^-24 reflects in spite of xi.
    const bool reflected = glm::dot(t, n) * glm::dot(d, n) < 0.0;
    side.holds(reflected == (sine > 1.0) || sine > 0.999, reflected, sine > 1.0, where);
    if (reflected) continue;
    snell.near(etaI * glm::length(across) - etaT * glm::length(t - glm::dot(t, n) * n), 0.0,
               3e-7 * std::max(etaI, etaT), where);
    if (glm::length(across) > 1e-2)
      plane.near(glm::dot(t, glm::normalize(glm::cross(across, n))), 0.0, 3e-7, where);
    if (std::abs(glm::dot(t, n)) > 1e-3)
      origin.holds(glm::dot(vec(got.at(i, 2)), n) * glm::dot(t, n) > 0.0, glm::dot(vec(got.at(i, 2)), n), 0.0,
                   where);
  }
}

TEST_P(Scatter, RefractionIsReversible) {
  Random random(103);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < (1 << 18); ++i) {
    Case c = arriving(random, dielectric, 1e-3);
    c.roughness = 0.0;
    c.index = random.uniform(1.0, 3.0);
    c.xi.z = 1.0 - 0x1p-24;
    cases.push_back(c);
  }
  const Table there = table_of(cases);
  const Table got = run(probe(0), there);
  Table back = there;
  for (std::size_t i = 0; i < cases.size(); ++i) back.at(i, 0) = texel(-vec(got.at(i, 1)), dielectric);
  const Table returned = run(probe(0), back);
  Bar bar("refraction and back, distance from where it came over 1 / cos");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double cosine = -glm::dot(vec(there.at(i, 0)), vec(there.at(i, 1)));
    const bool crossed = glm::dot(vec(got.at(i, 1)), vec(there.at(i, 1))) < 0.0 &&
                         glm::dot(vec(returned.at(i, 1)), vec(there.at(i, 1))) > 0.0;
    if (crossed)
      bar.near(glm::distance(vec(returned.at(i, 1)), -vec(there.at(i, 0))), 0.0,
               8.0 * u * cases[i].index * cases[i].index / cosine, {{"case", i}, {"cosine", cosine}});
  }
}

TEST_P(Scatter, DiffuseKeepsItsAlbedoFromBothSides) {
  Random random(106);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    Case c = arriving(random, diffuse);
    c.color = {i % 3 == 0 ? 0.0 : random.uniform(), i % 3 == 1 ? 1.0 : random.uniform(), random.uniform()};
    if (i % 2) c.normal = -c.normal;
    cases.push_back(c);
  }
  const Table inputs = table_of(cases);
  const Table got = run(probe(0), inputs);
  Bar weight("diffuse, attenuation");
  Bar side("diffuse, directions that transmit");
  Bar density("diffuse, pdf over cos / pi");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 d = vec(inputs.at(i, 0));
    glm::dvec3 n = vec(inputs.at(i, 1));
    if (glm::dot(d, n) > 0.0) n = -n;
    const double cosine = glm::dot(n, vec(got.at(i, 1)));
    const Bar::Inputs where = {{"case", i}};
    side.holds(cosine > -2.0 * u, cosine, 0.0, where);
    if (got.at(i, 0).w == 0.0F) continue;
    for (int j = 0; j < 3; ++j) weight.near(got.at(i, 0)[j], inputs.at(i, 2)[j], 0.0, where);
    density.near(got.at(i, 1).w, cosine / pi, 4.0 * u, where);
    EXPECT_EQ(got.at(i, 2).w, 0.25F) << "the new ray keeps the time";
  }
}

TEST_P(Scatter, WeightsAndDensitiesOfMetalsAreThoseOfVisibleNormals) {
  Random random(107);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    Case c = arriving(random, conductor, 1e-2);
    c.normal = {0, 0, 1};
    const double cosine = random.log_uniform(1e-2, 1.0);
    const double turn = 2.0 * pi * random.uniform();
    c.direction = {std::sqrt(1.0 - cosine * cosine) * std::cos(turn),
                   std::sqrt(1.0 - cosine * cosine) * std::sin(turn), -cosine};
    c.color = glm::dvec3(1);
    c.extra = glm::dvec3(1);
    c.roughness = random.uniform(0.1, 1.0);
    cases.push_back(c);
  }
  const Table inputs = table_of(cases);
  const Table got = run(probe(0, {{"FRESNEL", "1"}, {"ENERGY_COMPENSATION", "0"}}), inputs);
  Bar weight("metal, weight of a sample over G2 / G1");
  Bar bound("metal, weights outside [0, 1]");
  Bar density("metal, pdf, relative error");
  for (std::size_t i = 0; i < million; ++i) {
    if (got.at(i, 0).w == 0.0F) continue;
    const glm::dvec3 v = glm::normalize(-vec(inputs.at(i, 0)));
    const glm::dvec3 l = glm::normalize(vec(got.at(i, 1)));
    const double alpha = static_cast<double>(inputs.at(i, 1).w) * static_cast<double>(inputs.at(i, 1).w);
    const Bar::Inputs where = {{"case", i}, {"alpha", alpha}, {"NoV", v.z}, {"NoL", l.z}};
    bound.holds(got.at(i, 0).x >= 0.0F && got.at(i, 0).x <= 1.0F + 8.0F * static_cast<float>(u),
                got.at(i, 0).x, 1.0, where);
    if (l.z < 1e-3) continue;
    const double expected = ggx::masking_shadowing(v.z, l.z, alpha) / ggx::masking(v.z, alpha);
    // The direction is known to a few units: worth that over its cosine.
    weight.near(got.at(i, 0).x, expected, (1e-6 + 4.0 * u / l.z) * expected, where);
    const double pdf = ggx::visible_pdf(v, l, alpha);
    // h is known to a few units over its length before it is normalised, and D falls within alpha of its
    // peak.
    density.near(got.at(i, 1).w, pdf, (2e-6 + 16.0 * u / (alpha * glm::length(v + l))) * pdf, where);
  }
}

TEST_P(Scatter, ExtremesGiveNumbers) {
  Random random(110);
  for (const char* sampling : {"0", "1", "2"}) {
    std::vector<Case> cases;
    const std::vector<double> edges = {0.0, 0x1p-24, 0.5, 1.0 - 0x1p-24};
    for (std::size_t i = 0; i < million; ++i) {
      Case c = arriving(random, static_cast<Type>(i % 5), 1e-7);
      const auto pick = [&](double otherwise) {
        return random.uniform() < 0.5 ? otherwise : edges[static_cast<std::size_t>(random.uniform() * 4.0)];
      };
      c.roughness = random.uniform() < 0.3 ? (random.uniform() < 0.5 ? 0.0 : 1.0) : random.uniform(-0.5, 1.5);
      c.color = {pick(random.uniform()), pick(random.uniform()), 1.0};
      c.index = random.uniform() < 0.2 ? 1.0 : random.uniform(0.0, 6.0);
      for (int j = 0; j < 4; ++j) c.xi[j] = pick(random.uniform());
      c.extra = {random.uniform() < 0.2 ? -1.0 : random.log_uniform(1e-6, 1e4), 0.0, 1.0};
      c.way = random.log_uniform(1e-6, 1e6);
      if (random.uniform() < 0.1) c.direction = -c.normal;  // straight on
      if (random.uniform() < 0.3) c.normal = -c.normal;
      if (random.uniform() < 0.05) c.normal = {0, 0, -1};
      cases.push_back(c);
    }
    const Table inputs = table_of(cases);
    const Table got = run(probe(0, {{"SPECULAR_SAMPLING", sampling}}), inputs);
    Bar finite("scatter at its extremes, results that are no numbers");
    Bar unit("scatter at its extremes, length of the direction");
    for (std::size_t i = 0; i < million; ++i) {
      if (got.at(i, 0).w == 0.0F) continue;
      const Bar::Inputs where = {{"case", i},
                                 {"type", i % 5},
                                 {"roughness", cases[i].roughness},
                                 {"NoV", glm::dot(vec(inputs.at(i, 0)), vec(inputs.at(i, 1)))}};
      bool good = std::isfinite(got.at(i, 1).w) && got.at(i, 1).w >= 0.0F;
      for (int j = 0; j < 3; ++j)
        good = good && std::isfinite(got.at(i, 0)[j]) && got.at(i, 0)[j] >= 0.0F &&
               std::isfinite(got.at(i, 2)[j]);
      finite.holds(good, got.at(i, 0).x, got.at(i, 1).w, where);
      unit.near(glm::length(vec(got.at(i, 1))), 1.0, 4.0 * u, where);
    }
  }
}

}  // namespace
}  // namespace shadertwin::scatter_test
