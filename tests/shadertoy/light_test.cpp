// Direct light: quad lights against closed forms with every strategy, shadows of moving things, and the
// weights.
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin {
namespace {

class QuadLights : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(QuadLights);
class QuadLightStrategies : public OnEveryBackend {};
SHADERTWIN_ON_FIRST_BACKEND(QuadLightStrategies);
class Shadows : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Shadows);

using std::numbers::pi;
constexpr double u = unit_roundoff;
const Probe lights{.file = "lights.glsl", .inputs = 5, .outputs = 3};
const Probe shadows{.file = "shadows.glsl", .inputs = 1, .outputs = 1};

glm::dvec3 vec(const glm::vec4& v) {
  return glm::dvec3(v);
}

struct Floor {
  double width, depth, height, albedo, radiance;
};

// Irradiance over radiance of a polygon with corners v, seen from the origin by a surface of normal n:
// Lambert's formula, a sum over the edges.
double lambert(const std::vector<glm::dvec3>& v, const glm::dvec3& n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const glm::dvec3 a = glm::normalize(v[i]);
    const glm::dvec3 b = glm::normalize(v[(i + 1) % v.size()]);
    const glm::dvec3 across = glm::cross(a, b);
    sum += std::atan2(glm::length(across), glm::dot(a, b)) * glm::dot(n, glm::normalize(across));
  }
  return std::abs(sum) / 2.0;
}

// Radiance of the floor at (x, 0, z).
double closed_form(const Floor& f, double x, double z) {
  const double a = f.width / 2.0;
  const double b = f.depth / 2.0;
  const double irradiance = lambert({{-a - x, f.height, -b - z},
                                     {a - x, f.height, -b - z},
                                     {a - x, f.height, b - z},
                                     {-a - x, f.height, b - z}},
                                    {0, 1, 0});
  return f.albedo / pi * f.radiance * irradiance;
}

TEST(QuadLightOracle, GivesTheTable) {
  const std::array<std::pair<Floor, double>, 3> rows = {
      {{{1, 1, 1, 1, 1}, .2394564705}, {{2, 2, 1, 1, 1}, .5541264240}, {{10, 5, 24.8, .7, 20}, .3504707896}}};
  for (const auto& [floor, expected] : rows) EXPECT_NEAR(closed_form(floor, 0, 0), expected, 1e-10);
}

std::string glsl(double value) {
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint << value;
  return text.str();
}

TEST_P(QuadLightStrategies, AllGiveTheClosedForm) {
  constexpr std::size_t batches = 64;
  const std::vector<glm::dvec2> points = {{0, 0}, {0.7, 0.2}, {3, -2}};
  for (const Floor& floor : {Floor{1, 1, 1, 1, 1}, Floor{2, 2, 1, 1, 1}, Floor{10, 5, 24.8, .7, 20}})
    for (const char* strategy : {"0", "1", "2", "3"}) {
      const Probe paths{
          .file = "paths.glsl",
          .inputs = 2,
          .outputs = 3,
          .defines = {{"ROOM", "0"},
                      {"SAMPLES", "512"},
                      {"LIGHT_STRATEGY", strategy},
                      {"ALBEDO", glsl(floor.albedo)},
                      {"RADIANCE", glsl(floor.radiance)},
                      {"LIGHT_HEIGHT", glsl(floor.height)},
                      {"LIGHT_SIZE", "vec2(" + glsl(floor.width) + ", " + glsl(floor.depth) + ")"}}};
      Table inputs(points.size() * batches, 2);
      for (std::size_t i = 0; i < inputs.cases(); ++i) {
        const glm::dvec2 p = points[i / batches];
        const glm::dvec3 eye(p.x + 0.1, 0.5 * floor.height, p.y + 0.1);
        inputs.at(i, 0) = texel(eye, static_cast<double>(i % batches));
        inputs.at(i, 1) = texel(glm::normalize(glm::dvec3(p.x, 0, p.y) - eye));
      }
      const Table got = run(paths, inputs);
      for (std::size_t k = 0; k < points.size(); ++k) {
        std::vector<double> means;
        for (std::size_t b = 0; b < batches; ++b) {
          means.push_back(got.at(k * batches + b, 0).x);
          EXPECT_EQ(got.at(k * batches + b, 2).z, 0.0F);
        }
        const double expected = closed_form(floor, points[k].x, points[k].y);
        expect_mean("strategy " + std::string(strategy) + ", light " + glsl(floor.width) + " by " +
                        glsl(floor.depth) + " at " + glsl(floor.height) + ", point " + std::to_string(k),
                    means, expected, 2e-6 * expected);
      }
    }
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

}  // namespace
}  // namespace shadertwin
