// scatter and evaluateBsdf of every material: perfect directions, fuzzy ones, densities, reciprocity, and
// extremes.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/ggx.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin {
namespace {

class Scatter : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Scatter);

using std::numbers::pi;
constexpr std::size_t million = std::size_t{1} << 20;
constexpr double u = unit_roundoff;
enum Type { diffuse, metal, dielectric, conductor, plastic };

Probe probe(int function, std::vector<std::pair<std::string, std::string>> defines = {}) {
  return {
      .file = "scatter.glsl", .function = function, .inputs = 6, .outputs = 3, .defines = std::move(defines)};
}

struct Case {
  Type type = diffuse;
  glm::dvec3 direction{0, 0, -1}, normal{0, 0, 1};
  double roughness = 0.5;
  glm::dvec3 color{0.5};
  double index = 1.5;
  glm::dvec4 xi{0.5};
  glm::dvec3 extra{0};
  double way = 1;
};

glm::dvec3 vec(const glm::vec4& v) {
  return glm::dvec3(v);
}

Table table_of(const std::vector<Case>& cases) {
  Table inputs(cases.size(), 6);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    inputs.at(i, 0) = texel(glm::normalize(c.direction), c.type);
    inputs.at(i, 1) = texel(glm::normalize(c.normal), c.roughness);
    inputs.at(i, 2) = texel(c.color, c.index);
    inputs.at(i, 3) = glm::vec4(c.xi);
    inputs.at(i, 4) = texel(c.extra);
    inputs.at(i, 5) = texel(glm::dvec3(1, 2, 3) - c.way * vec(inputs.at(i, 0)));
  }
  return inputs;
}

glm::dvec4 random_xi(Random& random) {
  return {random.uniform(), random.uniform(), random.uniform(), random.uniform()};
}

// Arrives at the front of a random surface with a cosine of all scales.
Case arriving(Random& random, Type type, double least = 1e-3) {
  Case c;
  c.type = type;
  c.normal = random_direction(random);
  const double cosine = random.log_uniform(least, 1.0);
  c.direction = std::sqrt(1.0 - cosine * cosine) * random_across(random, c.normal) - cosine * c.normal;
  c.xi = random_xi(random);
  return c;
}

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

TEST_P(Scatter, GlassReflectsAsOftenAsFresnelSays) {
  std::vector<Case> cases;
  Random random(104);
  constexpr std::size_t each = 1 << 13;
  for (int angle = 0; angle < 20; ++angle)
    for (const double index : {1.1, 1.33, 1.5, 2.4})
      for (std::size_t i = 0; i < each; ++i) {
        Case c;
        c.type = dielectric;
        c.roughness = i % 2 ? 0.0 : 0.3;
        c.index = index;
        const double theta = (angle + 0.5) * pi / 40.0;
        c.direction = {std::sin(theta), 0, -std::cos(theta)};
        if (angle % 2) c.direction.z = -c.direction.z;  // from within
        c.xi = random_xi(random);
        cases.push_back(c);
      }
  const Table inputs = table_of(cases);
  const Table got = run(probe(0), inputs);
  for (std::size_t group = 0; group < cases.size(); group += each) {
    const glm::dvec3 d = vec(inputs.at(group, 0));
    const double c = std::abs(d.z);
    const double eta = d.z > 0.0 ? 1.0 / static_cast<double>(inputs.at(group, 2).w) : inputs.at(group, 2).w;
    const double s2 = (1.0 - c * c) / (eta * eta);
    const double t = std::sqrt(std::max(0.0, 1.0 - s2));
    const double rs = (c - eta * t) / (c + eta * t);
    const double rp = (eta * c - t) / (eta * c + t);
    const double expected = s2 >= 1.0 ? 1.0 : 0.5 * (rs * rs + rp * rp);
    double count = 0.0;
    for (std::size_t i = group; i < group + each; ++i) count += got.at(i, 1).z * d.z < 0.0 ? 1.0 : 0.0;
    const double sigma = std::sqrt(expected * (1.0 - expected) / each);
    EXPECT_NEAR(count / each, expected, test_sigmas * sigma + 1e-6)
        << "cosine " << d.z << ", index " << cases[group].index;
  }
}

// The part of a ball of radius r at distance 1 that a cone around its centre with cosine c does not hold.
double beyond_cone(double c, double r) {
  const double least = std::sqrt(std::max(0.0, 1.0 - r * r));
  const auto chord = [r](double x) {
    const double root = std::sqrt(std::max(0.0, x * x - 1.0 + r * r));
    return (std::pow(x + root, 3) - std::pow(std::max(0.0, x - root), 3)) / 3.0;
  };
  return c <= least ? 0.0 : integrate(chord, least, c) * 2.0 * pi / (4.0 / 3.0 * pi * r * r * r);
}

TEST_P(Scatter, FuzzyDirectionsAreABallAroundTheMirrorDirection) {
  for (const double r : {0.1, 0.5, 1.0}) {
    Random random(105);
    constexpr std::size_t count = 1 << 18;
    std::vector<Case> cases(count);
    for (Case& c : cases) {
      c.type = metal;
      c.roughness = r;
      c.direction = {0.3, -0.1, -1};
      c.xi = random_xi(random);
    }
    const Table inputs = table_of(cases);
    const Table got = run(probe(0), inputs);
    const glm::dvec3 d = vec(inputs.at(0, 0));
    const glm::dvec3 mirror = glm::normalize(glm::dvec3(d.x, d.y, -d.z));
    const glm::dvec3 side = glm::normalize(glm::cross(mirror, glm::dvec3(0, 0, 1)));
    const glm::dvec3 other = glm::cross(mirror, side);
    constexpr std::size_t cells = 64;
    std::vector<double> counts(cells);
    std::vector<double> expected(cells);
    std::vector<double> turn;
    const double least = std::sqrt(1.0 - r * r);
    const auto edge = [&](std::size_t k) { return least + (1.0 - least) * static_cast<double>(k) / cells; };
    for (std::size_t k = 0; k < cells; ++k)
      expected[k] = count * (beyond_cone(edge(k + 1), r) - beyond_cone(edge(k), r));
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 way = vec(got.at(i, 1));
      const double c = std::clamp(glm::dot(way, mirror), least, 1.0);
      counts[std::min(static_cast<std::size_t>((c - least) / (1.0 - least) * cells), cells - 1)] += 1.0;
      turn.push_back(std::atan2(glm::dot(way, other), glm::dot(way, side)) / (2.0 * pi) + 0.5);
    }
    expect_plausible("fuzzy mirror, angle to the mirror direction, roughness " + std::to_string(r),
                     chi_square_p(counts, expected));
    expect_uniform("fuzzy mirror, around the mirror direction, roughness " + std::to_string(r), turn, 256);
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

TEST_P(Scatter, EvaluatedAndSampledDensitiesAgree) {
  // Mean of g / pdf over samples is the integral of g, for g = cos^2 in cells of the hemisphere.
  constexpr int rings = 6;
  constexpr int sectors = 8;
  constexpr std::size_t count = million / 4;
  for (const Type type : {diffuse, plastic})
    for (const double r : {0.1, 0.5, 1.0}) {
      if (type == diffuse && r != 1.0) continue;
      Random random(108);
      std::vector<Case> cases(count);
      for (Case& c : cases) {
        c.type = type;
        c.roughness = r;
        c.color = glm::dvec3(0.8);
        c.direction = {0.8, 0, -0.6};
        c.xi = random_xi(random);
      }
      const Table inputs = table_of(cases);
      const Table got = run(probe(0), inputs);
      std::vector<std::vector<double>> values(rings * sectors, std::vector<double>(count / 1024));
      for (std::size_t i = 0; i < count; ++i) {
        if (got.at(i, 0).w == 0.0F) continue;
        const glm::dvec3 l = vec(got.at(i, 1));
        const auto ring = std::min(static_cast<std::size_t>(l.z * rings), std::size_t{rings - 1});
        const auto sector =
            std::min(static_cast<std::size_t>((std::atan2(l.y, l.x) / (2.0 * pi) + 0.5) * sectors),
                     std::size_t{sectors - 1});
        values[ring * sectors + sector][i / 1024] += l.z * l.z / static_cast<double>(got.at(i, 1).w) / 1024.0;
      }
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double low = static_cast<double>(k / sectors) / rings;
        const double high = low + 1.0 / rings;
        const double expected = (high * high * high - low * low * low) / 3.0 * 2.0 * pi / sectors;
        expect_mean("type " + std::to_string(type) + ", roughness " + std::to_string(r) + ", cell " +
                        std::to_string(k),
                    values[k], expected, 1e-6);
      }
      // And what scatter returns is what evaluateBsdf says of that direction.
      Table towards = inputs;
      for (std::size_t i = 0; i < count; ++i) towards.at(i, 3) = got.at(i, 1);
      const Table evaluated = run(probe(1), towards);
      Bar pdf("pdf of evaluateBsdf against scatter, relative");
      Bar weight("BRDF over pdf of evaluateBsdf against scatter, relative");
      for (std::size_t i = 0; i < count; ++i) {
        if (got.at(i, 0).w == 0.0F || got.at(i, 1).z < 1e-3F) continue;
        const double p = got.at(i, 1).w;
        const double slack = 2e-6 + 64.0 * u / (r * r) + 8.0 * u / static_cast<double>(got.at(i, 1).z);
        pdf.near(evaluated.at(i, 0).w, p, slack * p, {{"case", i}, {"type", type}, {"roughness", r}});
        weight.near(static_cast<double>(evaluated.at(i, 0).x) / p, got.at(i, 0).x,
                    slack * static_cast<double>(got.at(i, 0).x) + 1e-7,
                    {{"case", i}, {"type", type}, {"roughness", r}});
      }
    }
}

TEST_P(Scatter, BrdfsAreReciprocalAndPositive) {
  Random random(109);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    Case c = arriving(random, i % 3 == 0 ? diffuse : i % 3 == 1 ? conductor : plastic, 1e-2);
    c.normal = {0, 0, 1};
    const auto direction = [&] {
      const double cosine = random.log_uniform(1e-2, 1.0);
      const double turn = 2.0 * pi * random.uniform();
      return glm::dvec3(std::sqrt(1.0 - cosine * cosine) * std::cos(turn),
                        std::sqrt(1.0 - cosine * cosine) * std::sin(turn), cosine);
    };
    c.direction = -direction();
    c.xi = glm::dvec4(direction(), 0);
    c.color = {random.uniform(), random.uniform(), random.uniform()};
    c.extra = c.color;
    c.roughness = random.uniform(0.05, 1);
    cases.push_back(c);
  }
  const Table there = table_of(cases);
  Table back = there;
  for (std::size_t i = 0; i < million; ++i) {
    back.at(i, 0) = texel(-vec(there.at(i, 3)), there.at(i, 0).w);
    back.at(i, 3) = texel(-vec(there.at(i, 0)));
  }
  const std::vector<std::pair<std::string, std::string>> defines = {{"ENERGY_COMPENSATION", "0"}};
  const Table f = run(probe(1, defines), there);
  const Table g = run(probe(1, defines), back);
  Bar bar("BRDF there and back, relative difference");
  Bar positive("BRDF, negative or infinite values");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const double forward = static_cast<double>(f.at(i, 0)[j]) / static_cast<double>(there.at(i, 3).z);
      const double backward = static_cast<double>(g.at(i, 0)[j]) / static_cast<double>(back.at(i, 3).z);
      const Bar::Inputs where = {{"case", i}, {"type", i % 3}, {"roughness", cases[i].roughness}};
      // The reflectance of a metal is a difference of numbers near 1, and its index grows without bound
      // towards F0 = 1.
      const double f0 = cases[i].color[j];
      const double slack = 2e-6 + (i % 3 == 1 ? 8.0 * u / f0 + 8.0 * u / (1.001 - f0) : 0.0);
      // And the half vector of two that nearly cancel is known to a few units over its length.
      const double half = glm::length(vec(there.at(i, 3)) - vec(there.at(i, 0)));
      bar.near(forward, backward, (slack + 32.0 * u / half) * std::max(forward, backward), where);
      positive.holds(f.at(i, 0)[j] >= 0.0F && std::isfinite(f.at(i, 0)[j]), f.at(i, 0)[j], 0.0, where);
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
}  // namespace shadertwin
