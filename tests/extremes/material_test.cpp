// Materials at the ends of what they take: every roughness and index, the critical angle, grazing light, the
// least and the greatest random numbers, normals at the poles of the basis, and absorption from none to all.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/scattering.h"

namespace shadertwin::material_test {
namespace {

class Materials : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Materials);

using namespace scattering;  // NOLINT(google-build-using-namespace)
constexpr double u = unit_roundoff;

// Along the axes and beside the pole at which the basis turns around.
const std::vector<glm::dvec3> normals = {{1, 0, 0},    {0, 1, 0},       {0, 0, 1},     {-1, 0, 0},
                                         {0, -1, 0},   {0, 0, -1},      {1e-7, 0, -1}, {0, -1e-4, -1},
                                         {1e-4, 0, 1}, {1, 1e-8, -1e-8}};
const std::vector<double> cosines = {1.0, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
const std::vector<double> roughnesses = {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.0316, 0.0317, 0.1, 0.5, 1.0};
const std::vector<double> indices = {0.2, 0.5, 1.0 - u, 1.0, 1.0 + 2.0 * u, 1.5, 5.0};
constexpr double last = 1.0 - 0x1p-24;  // random number

// All of them with all: 16 corners of the random numbers each.
std::vector<Case> corners() {
  std::vector<Case> cases;
  for (const Type type : {diffuse, metal, dielectric, conductor, plastic})
    for (const glm::dvec3& n : normals)
      for (const double cosine : cosines)
        for (const double roughness : roughnesses)
          for (const double index : indices) {
            if (type != dielectric && index != 1.5) continue;
            if (type == diffuse && roughness != 0.0) continue;
            for (int corner = 0; corner < 16; ++corner) {
              Case c;
              c.type = type;
              c.normal = n;
              const glm::dvec3 unit = glm::normalize(n);
              const glm::dvec3 side = glm::normalize(glm::cross(unit, {0.3, 0.5, 0.7}));
              c.direction = std::sqrt(1.0 - cosine * cosine) * side - cosine * unit;
              if (corner % 3 == 0) c.normal = -c.normal;
              c.roughness = roughness;
              c.index = index;
              c.color = {1.0, 0.5, 0.0};
              c.extra = type == conductor ? glm::dvec3(1.0) : glm::dvec3(0.0, 1.0, 1e4);
              for (int bit = 0; bit < 4; ++bit) c.xi[bit] = (corner >> bit) % 2 ? last : 0.0;
              cases.push_back(c);
            }
          }
  return cases;
}

TEST_P(Materials, ScatterNumbersAtEveryCorner) {
  const std::vector<Case> cases = corners();
  const Table inputs = table_of(cases);
  Bar weight("scatter at every corner, weights beyond their bound");
  for (const char* sampling : {"0", "1"}) {
    const Table got = run(probe(0, {{"SPECULAR_SAMPLING", sampling}}), inputs);
    Bar finite("scatter at every corner, results that are no numbers");
    Bar unit("scatter at every corner, length of the direction");
    Bar side("scatter at every corner, directions to the wrong side");
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (got.at(i, 0).w == 0.0F) continue;
      const Case& c = cases[i];
      const Bar::Inputs where = {{"case", i},
                                 {"type", c.type},
                                 {"cosine", glm::dot(c.direction, c.normal)},
                                 {"roughness", c.roughness},
                                 {"index", c.index}};
      const glm::dvec3 n = vec(inputs.at(i, 1));
      const double arrives = glm::dot(vec(inputs.at(i, 0)), n);
      bool good = std::isfinite(got.at(i, 1).w) && got.at(i, 1).w >= 0.0F;
      double largest = 0.0;
      for (int j = 0; j < 3; ++j) {
        good = good && std::isfinite(got.at(i, 0)[j]) && got.at(i, 0)[j] >= 0.0F &&
               std::isfinite(got.at(i, 2)[j]);
        largest = std::max(largest, static_cast<double>(got.at(i, 0)[j]));
      }
      finite.holds(good, got.at(i, 0).x, got.at(i, 1).w, where);
      unit.near(glm::length(vec(got.at(i, 1))), 1.0, 4.0 * u, where);
      // Only glass lets light through. At a cosine of a few units which side is rounding.
      if (c.type != dielectric && std::abs(arrives) > 8.0 * u)
        side.holds(glm::dot(vec(got.at(i, 1)), n) * arrives < 8.0 * u * std::abs(arrives),
                   glm::dot(vec(got.at(i, 1)), n), arrives, where);
      // A visible normal weighs at most what is given back to rough metal, 1 / E; plastic follows its gloss
      // at least one time in twenty. Any normal has no bound: the weight is VoH / (NoV NoH).
      if (sampling[0] == '0') {
        const double bound = c.type == plastic ? 20.0 : c.type == conductor ? 3.5 : 1.0;
        weight.holds(largest <= bound * (1.0 + 8.0 * u), largest, bound, where);
      }
    }
  }
}

// Rounding decides between reflection and refraction only where the reflectance itself is that close to the
// random number; elsewhere float and double scatter alike.
TEST_P(Materials, GlassIsThatOfDoubleUpToTheCriticalAngle) {
  std::vector<Case> cases;
  std::vector<bool> total;
  for (double index = 1.02; index < 5.0; index *= 1.02) {
    const auto held = static_cast<double>(static_cast<float>(index));
    const double critical = std::sqrt((1.0 - 1.0 / held) * (1.0 + 1.0 / held));
    for (const double away : {-1e-1, -1e-2, -1e-3, -1e-4, -1e-5, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
      const double cosine = critical * (1.0 + away);
      if (cosine >= 1.0) continue;
      Case c;
      c.type = dielectric;
      c.roughness = 0.0;
      c.index = held;
      c.normal = {0, 0, 1};
      c.direction = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};  // from within
      c.xi = glm::dvec4(last);
      cases.push_back(c);
      total.push_back(away < 0.0);
    }
  }
  const Table got = run(probe(0), table_of(cases));
  Bar decision("glass beside the critical angle, total reflection or none");
  for (std::size_t i = 0; i < cases.size(); ++i)
    decision.holds((got.at(i, 1).z < 0.0F) == total[i], got.at(i, 1).z, total[i],
                   {{"case", i}, {"index", cases[i].index}, {"cosine", cases[i].direction.z}});
}

const Probe reflectance{.file = "fresnel.glsl", .function = 0};
const Probe absorption{.file = "fresnel.glsl", .function = 1};

// The floats around the critical angle, one by one.
TEST_P(Materials, ReflectanceClimbsToOneAtTheCriticalAngle) {
  constexpr int around = 64;
  std::vector<glm::vec4> rows;
  for (double index = 1.02; index < 5.0; index *= 1.02) {
    const auto n = static_cast<float>(index);
    const double inverse = 1.0 / static_cast<double>(n);
    auto c = static_cast<float>(std::sqrt((1.0 - inverse) * (1.0 + inverse)));
    for (int i = 0; i < around / 2; ++i) c = std::nextafter(c, 0.0F);
    for (int i = 0; i < around; ++i, c = std::nextafter(c, 2.0F)) rows.emplace_back(c, n, 1.0F, 0.0F);
  }
  Table inputs(rows.size(), 1);
  for (std::size_t i = 0; i < rows.size(); ++i) inputs.at(i, 0) = rows[i];
  const Table got = run(reflectance, inputs);
  Bar range("Fresnel within 32 floats of the critical angle, values outside [0.9, 1]");
  Bar falls("Fresnel within 32 floats of the critical angle, rises with the cosine");
  Bar ends("Fresnel 32 floats beyond the critical angle, not 1");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float f = got.at(i, 0).x;
    const Bar::Inputs where = {{"cosine", rows[i].x}, {"index", rows[i].y}};
    // 1 - F is some 8 n sqrt(floats away x 2^-23) at most.
    range.holds(f >= 0.9F && f <= 1.0F, f, 1.0, where);
    if (i % around == 0) ends.holds(f == 1.0F, f, 1.0, where);
    if (i % around > 0) falls.holds(f <= got.at(i - 1, 0).x, f, got.at(i - 1, 0).x, where);
  }
}

// Up to an index of 2 + sqrt(3) unpolarised light is reflected the more the flatter it comes; beyond it there
// is a dip.
TEST_P(Materials, ReflectanceGrowsTowardsGrazingLight) {
  constexpr std::size_t steps = 4096;
  std::vector<float> etas = {0.2F, 0.27F, 0.5F, 0.9F, 0.999F, 1.0F - 0x1p-24F, 1.0F + 0x1p-23F, 1.001F,
                             1.1F, 1.5F,  2.5F, 3.7F, 5.0F};
  Table inputs(etas.size() * steps, 1);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const double part = static_cast<double>(i % steps) / (steps - 1);
    // Half of them within 1e-7 to 1 of grazing, on a log scale.
    const double cosine = i % 2 ? part : std::pow(10.0, -7.0 * (1.0 - part));
    inputs.at(i, 0) = glm::vec4(cosine, 1.0F, etas[i / steps], 0.0F);
  }
  const Table got = run(reflectance, inputs);
  Bar range("Fresnel from normal to grazing, values outside [0, 1]");
  Bar grows("Fresnel from normal to grazing, growth with the cosine");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const float eta = etas[i / steps];
    const float f = got.at(i, 0).x;
    const Bar::Inputs where = {{"cosine", inputs.at(i, 0).x}, {"index", eta}};
    range.holds(f >= 0.0F && f <= 1.0F, f, 0.0, where);
    const bool no_dip = std::max(eta, 1.0F / eta) < 3.73F;
    if (no_dip && i % steps >= 2) grows.holds(f <= got.at(i - 2, 0).x + 5e-7F, f, got.at(i - 2, 0).x, where);
  }
}

TEST_P(Materials, AbsorptionOnlyTakesLight) {
  std::vector<double> depths = {0.0, 1e-30, 1e-10};
  for (double depth = 1e-8; depth < 1e4; depth *= 1.001) depths.push_back(depth);
  depths.push_back(1e4);
  const std::vector<double> lengths = {1.0, 1e-4, 1e4};
  Table inputs(depths.size() * lengths.size(), 1);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const double length = lengths[i / depths.size()];
    inputs.at(i, 0) = glm::vec4(glm::vec3(static_cast<float>(depths[i % depths.size()] / length)), length);
  }
  const Table got = run(absorption, inputs);
  Bar falls("transmittance, growth with the depth");
  Bar ends("transmittance, all of nothing and nothing of all");
  Bar error("transmittance from a depth of 0 to 10,000, error");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const double depth = static_cast<double>(inputs.at(i, 0).x) * static_cast<double>(inputs.at(i, 0).w);
    const float t = got.at(i, 0).x;
    const Bar::Inputs where = {{"depth", depth}};
    const double expected = std::exp(-depth);
    // 2^-126 and less is 0.
    error.near(t, expected, expected * (8.0 + 2.0 * depth) * 2.0 * u + 0x1p-125, where);
    if (i % depths.size() > 0)
      falls.holds(t <= got.at(i - 1, 0).x * (1.0F + 4e-7F), t, got.at(i - 1, 0).x, where);
    if (depth == 0.0) ends.near(t, 1.0, 0.0, where);
    if (depth > 100.0) ends.near(t, 0.0, 0.0, where);
  }
}

}  // namespace
}  // namespace shadertwin::material_test
