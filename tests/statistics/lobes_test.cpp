// Lobes: directions against their densities, shares of the branches, and reciprocity.
#include <cmath>

#include "tests/shadertoy/ggx.h"
#include "tests/shadertoy/scattering.h"
#include "tests/statistics/statistics.h"

namespace shadertwin::lobes_test {
namespace {

SHADERTWIN_STATISTICS(Lobes);

using std::numbers::pi;
using namespace scattering;  // NOLINT(google-build-using-namespace)
constexpr double u = unit_roundoff;
const Probe samples{.file = "microfacets.glsl", .function = 2, .inputs = 2, .outputs = 3};

TEST_P(Lobes, VisibleNormalsFollowTheirDistribution) {
  // In the stretched frame the mirror images of the view on visible normals are even on a cap of the sphere.
  for (const double alpha : {0.04, 0.25, 0.64, 1.0})
    for (const double mu : {1.0, 0.7, 0.3, 0.05}) {
      Random random = draw(94);
      constexpr std::size_t count = 1 << 18;
      Table inputs(count, 2);
      for (std::size_t i = 0; i < count; ++i) {
        inputs.at(i, 0) = texel(ggx::direction(mu), alpha);
        inputs.at(i, 1) = texel({random.uniform(), random.uniform(), 0});
      }
      const Table got = run(samples, inputs);
      const glm::dvec3 v = glm::normalize(glm::dvec3(inputs.at(0, 0)));
      const auto a = static_cast<double>(inputs.at(0, 0).w);
      const glm::dvec3 view = glm::normalize(glm::dvec3(a * v.x, a * v.y, v.z));
      const auto mirrored = [&](const glm::dvec4& h) {
        const glm::dvec3 s = glm::normalize(glm::dvec3(h.x / a, h.y / a, h.z));
        return 2.0 * glm::dot(s, view) * s - view;
      };
      const auto turn_of = [](const auto& m) { return std::atan2(m.y, m.x) / (2.0 * pi) + 0.5; };
      const auto height = column(got, [&](const auto& h) {
        return std::clamp((mirrored(h).z + view.z) / (1.0 + view.z), 0.0, 1.0);
      });
      const auto turn = column(got, [&](const auto& h) { return turn_of(mirrored(h)); });
      const auto any_normal = [&](const auto& m) {
        const double tangent2 = (m.x * m.x + m.y * m.y) / (m.z * m.z);
        return tangent2 / (a * a + tangent2);
      };
      const auto ndf = column(got, any_normal, 1);
      const auto ndf_turn = column(got, turn_of, 1);
      const std::string name = "alpha " + std::to_string(alpha) + ", cosine " + std::to_string(mu);
      expect_uniform("visible normals, " + name, height, 256);
      expect_uniform("angle of visible normals, " + name, turn, 256);
      expect_uniform_pairs("visible normals and angle, " + name, height, turn, 32);
      if (mu != 1.0) continue;
      expect_uniform("normals, " + name, ndf, 256);
      expect_uniform_pairs("normals and angle, " + name, ndf, ndf_turn, 32);
    }
}

TEST_P(Lobes, GlassReflectsAsOftenAsFresnelSays) {
  std::vector<Case> cases;
  Random random = draw(104);
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
    expect_share(
        "glass reflects, cosine " + std::to_string(d.z) + ", index " + std::to_string(cases[group].index),
        count, each, expected);
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

TEST_P(Lobes, FuzzyDirectionsAreABallAroundTheMirrorDirection) {
  for (const double r : {0.1, 0.5, 1.0}) {
    Random random = draw(105);
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

TEST_P(Lobes, EvaluatedAndSampledDensitiesAgree) {
  // Mean of g / pdf over samples is the integral of g, for g = cos^2 in cells of the hemisphere.
  constexpr int rings = 6;
  constexpr int sectors = 8;
  constexpr std::size_t count = million / 4;
  for (const Type type : {diffuse, plastic})
    for (const double r : {0.1, 0.5, 1.0}) {
      if (type == diffuse && r != 1.0) continue;
      Random random = draw(108);
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

TEST_P(Lobes, BrdfsAreReciprocalAndPositive) {
  Random random = draw(109);
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

// Of the hemisphere, in rings of even cosine and sectors of even angle.
constexpr std::size_t rings = 16;
constexpr std::size_t sectors = 32;

// How many of n directions each cell expects, by Simpson's rule: 9 x 9 points of a cell.
std::vector<double> expected_counts(const std::function<double(const glm::dvec3&)>& pdf, double n) {
  constexpr int steps = 8;
  std::vector<double> expected(rings * sectors);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const auto weight = [](int m) { return m == 0 || m == steps ? 1.0 : m % 2 ? 4.0 : 2.0; };
        const double z = (static_cast<double>(k / sectors) + static_cast<double>(i) / steps) / rings;
        const double turn =
            2.0 * pi * ((static_cast<double>(k % sectors) + static_cast<double>(j) / steps) / sectors - 0.5);
        const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
        sum += weight(i) * weight(j) * pdf({r * std::cos(turn), r * std::sin(turn), std::max(z, 1e-9)});
      }
    expected[k] = n * sum / (9.0 * steps * steps) * 2.0 * pi / (rings * sectors);
  }
  return expected;
}

TEST_P(Lobes, DirectionsHaveTheDensityThatTheyAreWeighedWith) {
  constexpr std::size_t count = 1 << 17;
  Random random = draw(111);
  for (const char* sampling : {"0", "1"})
    for (const Type type : {conductor, plastic})
      for (const double r : {0.6, 0.8, 1.0})
        for (const double mu : {0.95, 0.6, 0.2}) {
          std::vector<Case> cases(count);
          for (Case& c : cases) {
            c.type = type;
            c.roughness = r;
            c.color = glm::dvec3(0.8);
            c.extra = glm::dvec3(1);
            c.direction = {std::sqrt(1.0 - mu * mu), 0, -mu};
            c.xi = random_xi(random);
          }
          const Table inputs = table_of(cases);
          const std::vector<std::pair<std::string, std::string>> defines = {{"SPECULAR_SAMPLING", sampling}};
          const Table got = run(probe(0, defines), inputs);
          double gloss = 1.0;
          if (type == plastic) {
            cases.resize(1);
            gloss = run(probe(1, defines), table_of(cases)).at(0, 1).y;
          }
          const glm::dvec3 v = glm::normalize(-vec(inputs.at(0, 0)));
          const double alpha =
              static_cast<double>(inputs.at(0, 1).w) * static_cast<double>(inputs.at(0, 1).w);
          const auto pdf = [&](const glm::dvec3& l) {
            const glm::dvec3 h = glm::normalize(v + l);
            const double facets = sampling[0] == '0'
                                      ? ggx::visible_pdf(v, l, alpha)
                                      : ggx::distribution(h, alpha) * h.z / (4.0 * glm::dot(v, h));
            return gloss * facets + (1.0 - gloss) * l.z / pi;
          };
          std::vector<double> counts(rings * sectors);
          double below = count;
          for (std::size_t i = 0; i < count; ++i) {
            if (got.at(i, 0).w == 0.0F) continue;  // below the surface
            const glm::dvec3 l = vec(got.at(i, 1));
            const auto ring = std::min(static_cast<std::size_t>(l.z * rings), rings - 1);
            const auto sector = std::min(
                static_cast<std::size_t>((std::atan2(l.y, l.x) / (2.0 * pi) + 0.5) * sectors), sectors - 1);
            counts[ring * sectors + sector] += 1.0;
            below -= 1.0;
          }
          std::vector<double> expected = expected_counts(pdf, count);
          double above = 0.0;
          for (const double e : expected) above += e;
          counts.push_back(below);
          expected.push_back(std::max(count - above, 1e-9));
          expect_plausible("directions, SPECULAR_SAMPLING " + std::string(sampling) + ", type " +
                               std::to_string(type) + ", roughness " + std::to_string(r) + ", cosine " +
                               std::to_string(mu),
                           chi_square_p(counts, expected));
        }
}

}  // namespace
}  // namespace shadertwin::lobes_test
