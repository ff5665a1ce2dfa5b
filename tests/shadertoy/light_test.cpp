// Direct light: the densities and weights of quad lights, and shadows of moving things.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::light_test {
namespace {

class QuadLights : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(QuadLights);
class Shadows : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Shadows);

constexpr double u = unit_roundoff;
const Probe lights{.file = "lights.glsl", .inputs = 5, .outputs = 3};
const Probe shadows{.file = "shadows.glsl", .inputs = 1, .outputs = 1};

glm::dvec3 vec(const glm::vec4& v) {
  return glm::dvec3(v);
}

TEST_P(QuadLights, PointsAreUniformAndDensitiesPerSolidAngle) {
  constexpr std::size_t count = std::size_t{1} << 20;
  Random random(121);
  Table inputs(count, 5);
  for (std::size_t i = 0; i < count; ++i) {
    const double size = random.log_uniform(0.01, 100);
    const glm::dvec3 e1 = size * random_direction(random);
    const glm::dvec3 e2 = size * random.uniform(0.2, 5) * random_across(random, e1);
    inputs.at(i, 0) = texel(size * random_direction(random));
    inputs.at(i, 1) = texel(e1);
    inputs.at(i, 2) = texel(e2);
    glm::dvec3 eye = vec(inputs.at(i, 0)) + size * random.log_uniform(0.01, 100) * random_direction(random);
    if (i % 16 == 0)
      eye = vec(inputs.at(i, 0)) + random.uniform() * e1 + random.uniform() * e2;  // on the light itself
    inputs.at(i, 3) = texel(eye);
    inputs.at(i, 4) = glm::vec4(random.uniform(), random.uniform(), random.log_uniform(1e-6, 1e6),
                                i % 8 ? random.log_uniform(1e-6, 1e6) : 0.0);
  }
  const Table got = run(lights, inputs);
  Bar point("sampleQuadLight, position");
  Bar area("createQuadLight, area, relative");
  Bar pdf("pdfQuadLight, relative error");
  Bar behind("pdfQuadLight from behind or edge on");
  Bar power("powerHeuristic");
  Bar balance("balanceHeuristic");
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 corner = vec(inputs.at(i, 0));
    const glm::dvec3 e1 = vec(inputs.at(i, 1));
    const glm::dvec3 e2 = vec(inputs.at(i, 2));
    const glm::dvec4 xi(inputs.at(i, 4));
    const Bar::Inputs where = {{"case", i}};
    const double size = glm::length(e1) + glm::length(e2) + glm::length(corner);
    const glm::dvec3 target = vec(got.at(i, 0));
    point.near(glm::distance(target, corner + xi.x * e1 + xi.y * e2), 0.0, 4.0 * u * size, where);
    const double exact_area = glm::length(glm::cross(e1, e2));
    area.near(got.at(i, 0).w, exact_area, 8.0 * u * glm::length(e1) * glm::length(e2), where);
    const glm::dvec3 way = target - vec(inputs.at(i, 3));
    const double distance = glm::length(way);
    const double cosine = -glm::dot(way, glm::normalize(glm::cross(e1, e2))) / distance;
    const double reach = size + glm::length(vec(inputs.at(i, 3)));
    if (cosine < 0.0 && -cosine * distance > 8.0 * u * reach) behind.near(got.at(i, 1).w, 0.0, 0.0, where);
    if (cosine > 1e-2 && distance > 1e-3 * reach) {
      const double expected = distance * distance / (cosine * exact_area);
      pdf.near(got.at(i, 1).w, expected, 16.0 * u * expected * (1.0 + reach / (distance * cosine)), where);
    }
    EXPECT_TRUE(std::isfinite(got.at(i, 1).w));
    power.near(got.at(i, 2).x, xi.z * xi.z / (xi.z * xi.z + xi.w * xi.w), 4.0 * u, where);
    balance.near(got.at(i, 2).y, xi.z / (xi.z + xi.w), 4.0 * u, where);
  }
}

TEST_P(Shadows, MovingThingsShadowWhereTheyAreAtTheRaysTime) {
  constexpr std::size_t count = std::size_t{1} << 16;
  Random random(122);
  Table inputs(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = i % 4 == 0 ? 0.0 : i % 4 == 1 ? 1.0 : random.uniform();
    inputs.at(i, 0) = texel({random.uniform(-5, 6), -0.05, random.uniform(-5.5, 5)}, time);
  }
  const Table got = run(shadows, inputs);
  double shadowed = 0.0;
  double differ = 0.0;
  Bar lit("direct light where the light is visible");
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4 y = got.at(i, 0);
    shadowed += y.y == 0.0F ? 1.0 : 0.0;
    differ += y.x != y.y ? 1.0 : 0.0;
    const glm::dvec3 p = vec(inputs.at(i, 0));
    lit.holds(y.z == y.x, y.z, y.x, {{"x", p.x}, {"z", p.z}, {"time", inputs.at(i, 0).w}});
  }
  EXPECT_GT(shadowed, 0.05 * count) << "the test looks at shadows";
  // Both take another way to the same sum: a ray that grazes a ball may fall to either side.
  EXPECT_LE(differ, 1e-4 * count);
}

// A ceiling keeps all light from the floor, however close below the light it is, and none from above it.
TEST_P(Shadows, ReachUpToTheLight) {
  constexpr std::size_t count = 1024;
  Random random(123);
  Table inputs(count, 2);
  for (std::size_t i = 0; i < count; ++i) {
    inputs.at(i, 0) = texel({random.uniform(-3, 3), 0.25, random.uniform(-3, 3)}, static_cast<double>(i));
    inputs.at(i, 1) = texel({0, -1, 0});
  }
  Bar dark("floors under a ceiling, light");
  Bar lit("floors under a light below the ceiling, no light");
  for (const char* ceiling : {"0.5", "0.9", "0.99", "0.9999", "1.0001"}) {
    // A twin takes seconds to compile.
    if (GetParam() != backends().front().name && std::string(ceiling).size() < 6) continue;
    const Table got = run({.file = "paths.glsl",
                           .inputs = 2,
                           .outputs = 3,
                           .defines = {{"ROOM", "0"}, {"CEILING", ceiling}, {"SAMPLES", "16"}}},
                          inputs);
    for (std::size_t i = 0; i < count; ++i) {
      const Bar::Inputs where = {{"case", i}, {"ceiling", std::stod(ceiling)}};
      if (ceiling[0] == '0')
        dark.near(got.at(i, 2).x, 0.0, 0.0, where);
      else
        lit.holds(got.at(i, 0).x > 0.0F, got.at(i, 0).x, 1.0, where);
    }
  }
}

}  // namespace
}  // namespace shadertwin::light_test
