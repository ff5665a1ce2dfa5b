// GGX: the distribution, the masking terms, the reflectance of metals, and sampling, against double.
#include <complex>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/ggx.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::microfacets_test {
namespace {

class Microfacets : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Microfacets);

using std::numbers::pi;
const Probe terms{.file = "microfacets.glsl", .function = 0, .inputs = 2, .outputs = 3};
const Probe metals{.file = "microfacets.glsl", .function = 1, .inputs = 2, .outputs = 3};
const Probe samples{.file = "microfacets.glsl", .function = 2, .inputs = 2, .outputs = 3};

TEST_P(Microfacets, TermsAgreeWithDoubleForEveryAlphaAndCosine) {
  Random random(91);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    const double alpha = random.log_uniform(1e-3, 1.0);
    const double tangent = random.log_uniform(1e-3, 1e3) * alpha;
    const double turn = 2.0 * pi * random.uniform();
    inputs.at(i, 0) =
        texel(glm::normalize(glm::dvec3(tangent * std::cos(turn), tangent * std::sin(turn), 1.0)), alpha);
    inputs.at(i, 1) = texel(
        {i % 2 ? random.log_uniform(1e-7, 1) : random.uniform(0.001, 1), random.log_uniform(1e-7, 1), 0});
  }
  const Table got = run(terms, inputs);
  Bar distribution("D_GGX, relative error");
  Bar correlated("V_SmithGGXCorrelated, relative error");
  Bar separable("V_SmithGGX, relative error");
  Bar report("V_SmithSchlickGGX, relative error");
  Bar g1("G1_GGX, relative error");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec4 h(inputs.at(i, 0));
    const double v = inputs.at(i, 1).x;
    const double l = inputs.at(i, 1).y;
    const double alpha = h.w;
    const Bar::Inputs where = {{"alpha", alpha}, {"h.z", h.z}, {"NoV", v}, {"NoL", l}};
    // Of the vector as it is: its length is 1 to a unit only, and the shader does not ask.
    const double d = alpha * alpha / (pi * std::pow(alpha * alpha * h.z * h.z + h.x * h.x + h.y * h.y, 2));
    distribution.near(got.at(i, 0).x, d, 1e-6 * d, where);
    const double vc = ggx::masking_shadowing(v, l, alpha) / (4.0 * v * l);
    correlated.near(got.at(i, 0).y, vc, 1e-6 * vc, where);
    const double vs = ggx::masking(v, alpha) * ggx::masking(l, alpha) / (4.0 * v * l);
    separable.near(got.at(i, 0).z, vs, 1e-6 * vs, where);
    const double k = alpha / 2.0;
    const double vr = v / (v * (1.0 - k) + k) * l / (l * (1.0 - k) + k) / (4.0 * v * l);
    report.near(got.at(i, 0).w, vr, 1e-6 * vr, where);
    const double g = ggx::masking(v, alpha);
    g1.near(got.at(i, 1).x, g, 1e-6 * g, where);
  }
}

TEST_P(Microfacets, PeaksAndLimits) {
  Table inputs(3, 2);
  inputs.at(0, 0) = {0, 0, 1, 0.09F};
  inputs.at(1, 0) = {0, 0, 1, 1};
  inputs.at(2, 0) = {0, 0, 1, 0.001F};
  for (std::size_t i = 0; i < 3; ++i) inputs.at(i, 1) = {1, 1, 0, 0};
  const Table got = run(terms, inputs);
  EXPECT_NEAR(got.at(0, 0).x, 39.30, 0.005);
  EXPECT_NEAR(got.at(2, 0).x, 1e6 / pi, 1.0);
  EXPECT_NEAR(got.at(1, 0).x * got.at(1, 0).y, 1.0 / (4.0 * pi), 1e-7) << "v = l = n, alpha 1";
}

TEST_P(Microfacets, ProjectedAreaOfTheDistributionIsOne) {
  // Integral of D cos over the hemisphere, along tan^2 = alpha^2 u / (1 - u), where its density is even.
  constexpr int steps = 4096;
  const std::vector<double> alphas = {0.001, 0.02, 0.1, 0.25, 0.5, 1.0};
  Table inputs(alphas.size() * steps, 2);
  for (std::size_t k = 0; k < alphas.size(); ++k)
    for (std::size_t i = 0; i < steps; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / steps;
      const double tangent = alphas[k] * std::sqrt(u / (1.0 - u));
      inputs.at(k * steps + i, 0) = texel(glm::normalize(glm::dvec3(tangent, 0, 1)), alphas[k]);
      inputs.at(k * steps + i, 1) = texel({1, 1, 0});
    }
  const Table got = run(terms, inputs);
  for (std::size_t k = 0; k < alphas.size(); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < steps; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / steps;
      const double a2 = alphas[k] * alphas[k];
      const double tangent2 = a2 * u / (1.0 - u);
      const double cosine2 = 1.0 / (1.0 + tangent2);
      const double solid_angle = pi * cosine2 * std::sqrt(cosine2) * a2 / ((1.0 - u) * (1.0 - u));  // per u
      sum += static_cast<double>(got.at(k * steps + i, 0).x) * std::sqrt(cosine2) * solid_angle / steps;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5) << "alpha " << alphas[k];
  }
}

double complex_reflectance(double c, double eta, double k) {
  const std::complex<double> n2 = std::complex<double>(eta, k) * std::complex<double>(eta, k);
  const std::complex<double> root = std::sqrt(n2 - (1.0 - c * c));
  const double s = std::norm((c - root) / (c + root));
  const double p = std::norm((n2 * c - root) / (n2 * c + root));
  return 0.5 * (s + p);
}

// Metals absorb: k^2 from 0.25. Without absorption an index below 1 reflects totally, with an infinite slope.
TEST_P(Microfacets, MetalsReflectAsTheirComplexIndexSays) {
  Random random(92);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    const double c = i % 4 == 0 ? random.log_uniform(1e-6, 1) : random.uniform();
    inputs.at(i, 0) = texel(
        {random.log_uniform(0.0025, 100), random.log_uniform(0.0025, 100), random.log_uniform(0.0025, 100)},
        c);
    inputs.at(i, 1) =
        texel({random.log_uniform(0.25, 100), random.log_uniform(0.25, 100), random.log_uniform(0.25, 100)});
  }
  const Table got = run(metals, inputs);
  Bar bar("fresnelConductor, absolute error");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const double c = inputs.at(i, 0).w;
      const double eta = std::sqrt(static_cast<double>(inputs.at(i, 0)[j]));
      const double k = std::sqrt(static_cast<double>(inputs.at(i, 1)[j]));
      bar.near(got.at(i, 2)[j], complex_reflectance(c, eta, k), 5e-6,
               {{"cosine", c}, {"eta", eta}, {"k", k}});
    }
}

TEST_P(Microfacets, TintedMetalsKeepTheirColourAndStayWithinOne) {
  Random random(93);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    const double c = i % 4 == 0 ? 1.0 : i % 4 == 1 ? 0.0 : random.uniform();
    inputs.at(i, 0) = texel(
        {random.uniform(), i % 8 == 0 ? 1.0 : random.uniform(), i % 8 == 1 ? 0.0 : random.uniform()}, c);
    inputs.at(i, 1) =
        texel({random.uniform(), i % 8 == 0 ? 1.0 : random.uniform(), i % 8 == 1 ? 0.0 : random.uniform()});
  }
  const Table got = run(metals, inputs);
  Bar normal("F_Gulbrandsen at normal incidence, distance from F0");
  Bar grazing("metals at grazing incidence");
  Bar range("metals, values outside [0, 1]");
  Bar schlick("F_Schlick, absolute error");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const double f0 = inputs.at(i, 0)[j];
      const double c = inputs.at(i, 0).w;
      const double tinted = got.at(i, 1)[j];
      const Bar::Inputs where = {{"F0", f0}, {"edge", inputs.at(i, 1)[j]}, {"cosine", c}};
      // The complex index of a metal that reflects nearly all is known to as many units as it is large.
      if (c == 1.0) normal.near(tinted, std::min(f0, 0.999), f0 > 0.9 ? 5e-5 : 5e-6, where);
      if (c == 0.0 && f0 > 0.0) grazing.near(tinted, 1.0, 2e-6, where);
      range.holds(tinted >= 0.0 && tinted <= 1.0 + 2.0 * unit_roundoff, tinted, 1.0, where);
      schlick.near(got.at(i, 0)[j], f0 + (1.0 - f0) * std::pow(1.0 - c, 5), 4.0 * unit_roundoff, where);
    }
}

// Of Gulbrandsen's index, as his paper has it: n between (1 - r) / (1 + r), where the tint is 1, and
// (1 + sqrt r) / (1 - sqrt r). Where metals hardly absorb or reflect nearly all, n and k cancel.
TEST_P(Microfacets, TintedMetalsReflectAsTheIndexOfTheirTintSays) {
  Random random(94);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    inputs.at(i, 0) = texel({random.uniform(0.05, 0.9), random.uniform(0.05, 0.9), random.uniform(0.05, 0.9)},
                            random.uniform());
    inputs.at(i, 1) = texel({random.uniform(), random.uniform(), random.uniform()});
  }
  const Table got = run(metals, inputs);
  Bar bar("F_Gulbrandsen, absolute error");
  std::size_t judged = 0;
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 3; ++j) {
      const double r = inputs.at(i, 0)[j];
      const double tint = inputs.at(i, 1)[j];
      const double c = inputs.at(i, 0).w;
      const double eta =
          tint * (1.0 - r) / (1.0 + r) + (1.0 - tint) * (1.0 + std::sqrt(r)) / (1.0 - std::sqrt(r));
      const double k2 = (r * (eta + 1.0) * (eta + 1.0) - (eta - 1.0) * (eta - 1.0)) / (1.0 - r);
      if (k2 < 0.25) continue;
      ++judged;
      bar.near(got.at(i, 1)[j], complex_reflectance(c, eta, std::sqrt(k2)), 1e-5,
               {{"F0", r}, {"edge", tint}, {"cosine", c}});
    }
  EXPECT_GT(judged, million);
}

TEST_P(Microfacets, SampledNormalsAreOfUnitLengthAndFinite) {
  Random random(95);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    const double mu = i % 2 ? random.uniform() : random.log_uniform(1e-7, 1.0);
    const double turn = 2.0 * pi * random.uniform();
    const double sine = std::sqrt(1.0 - mu * mu);
    const auto edge = [&](int kind) {
      return kind == 0 ? 0.0 : kind == 1 ? 1.0 - 0x1p-24 : random.uniform();
    };
    inputs.at(i, 0) = texel({sine * std::cos(turn), sine * std::sin(turn), mu}, random.log_uniform(1e-3, 1));
    inputs.at(i, 1) = texel({edge(static_cast<int>(i % 5)), edge(static_cast<int>(i % 7)), 0});
  }
  const Table got = run(samples, inputs);
  Bar unit("sampled normals, length");
  Bar up("sampled normals below the surface");
  for (std::size_t i = 0; i < million; ++i)
    for (int j = 0; j < 2; ++j) {
      const glm::dvec3 h(got.at(i, j));
      const Bar::Inputs where = {
          {"case", i}, {"alpha", inputs.at(i, 0).w}, {"NoV", inputs.at(i, 0).z}, {"visible, all", j}};
      unit.near(glm::length(h), 1.0, (j == 0 ? 4.0 : 6.0) * unit_roundoff, where);
      up.holds(h.z >= 0.0, h.z, 0.0, where);
    }
}

}  // namespace
}  // namespace shadertwin::microfacets_test
