// Refraction and total reflection: balls of glass, solid and hollow, against closed forms and an independent
// trace.
#include <cmath>
#include <numbers>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::glass_test {
namespace {

class Glass : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Glass);

const Probe ball{.file = "glass.glsl", .inputs = 3, .outputs = 3};

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

Table parallel_rays(const std::vector<double>& impacts, double index, double inner, double absorption = 0.0) {
  Table inputs(impacts.size(), 3);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    inputs.at(i, 0) = texel({-5, impacts[i], 0});
    inputs.at(i, 1) = texel({1, 0, 0});
    inputs.at(i, 2) = texel({index, inner, absorption}, 1);
  }
  return inputs;
}

// Towards the axis.
double deviation(const glm::vec4& direction) {
  return degrees(-std::atan2(static_cast<double>(direction.y), static_cast<double>(direction.x)));
}

TEST_P(Glass, HollowBallsBendRaysAsTheClosedFormsSay) {
  constexpr double n = 1.33;
  constexpr double r = 0.5;
  const std::vector<double> impacts = {0, 0.1, 0.25, 0.4, 0.55, 0.7};
  const Table inputs = parallel_rays(impacts, n, -r);
  const Table got = run(ball, inputs);
  const std::vector<double> table = {0, -2.92220, -8.54882, -20.15404, -50.51, 25.34028};
  const std::vector<double> ways = {1.0, 1.00571, 1.03771, 1.10853, 1.25888, 1.70058};
  Bar bend("hollow ball, deviation in degrees");
  Bar way("hollow ball, way through glass");
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const auto b = static_cast<double>(inputs.at(i, 0).y);
    const auto index = static_cast<double>(inputs.at(i, 2).x);
    const double outer = 2.0 * (std::asin(b) - std::asin(b / index));
    double expected = outer;
    double length = 2.0 * std::sqrt(1.0 - b * b / (index * index));
    if (b < r) {
      expected -= 2.0 * (std::asin(b / r) - std::asin(b / (index * r)));
    } else if (b < index * r) {
      expected -= std::numbers::pi - 2.0 * std::asin(b / (index * r));  // off the cavity, outwards
    }
    if (b < index * r) length -= 2.0 * std::sqrt(r * r - b * b / (index * index));
    EXPECT_NEAR(length, ways[i], 1e-5) << "the closed form itself, b = " << b;
    EXPECT_NEAR(degrees(expected), table[i], 2e-2) << "the closed form itself, b = " << b;
    bend.near(deviation(got.at(i, 0)), degrees(expected), 2e-4, {{"b", b}});
    way.near(static_cast<double>(got.at(i, 0).w), length, 2e-6, {{"b", b}});
  }
}

TEST_P(Glass, WithTheSignOfTheRadiusIgnoredTheBallsAreAnotherThing) {
  Bar bar("inner ball of positive radius, deviation in degrees");
  const Table hollow = run(ball, parallel_rays({0.25, 0.4}, 1.33, 0.5));
  bar.near(deviation(hollow.at(0, 0)), 18.6129, 2e-3, {{"b", 0.25}});
  bar.near(deviation(hollow.at(1, 0)), 32.3288, 2e-3, {{"b", 0.4}});
  const Table solid = run(ball, parallel_rays({0.25}, 1.33, 0));
  bar.near(deviation(solid.at(0, 0)), 7.28635, 2e-4, {{"b", 0.25}});
}

TEST_P(Glass, SolidBallsBendEveryRayAsTheClosedFormSays) {
  Random random(71);
  Table inputs(million, 3);
  for (std::size_t i = 0; i < million; ++i) {
    const double impact = i % 16 == 0 ? random.log_uniform(1e-6, 1.0) : random.uniform(0.0, 0.98);
    const glm::dvec3 d = random_direction(random);
    const glm::dvec3 side = random_across(random, d);
    inputs.at(i, 0) = texel(impact * side - random.uniform(1.5, 5.0) * d);
    inputs.at(i, 1) = texel(d);
    inputs.at(i, 2) = texel({random.uniform(1.01, 2.5), 0, 0}, 1);
  }
  const Table got = run(ball, inputs);
  Bar bend("solid ball, deviation");
  Bar way("solid ball, way through glass");
  Bar plane("solid ball, distance of the new direction from the plane of incidence");
  Bar unit("solid ball, length of the direction");
  Bar path("solid ball, surfaces met");
  Bar trapped("solid ball, total reflections of rays from outside");
  Bar clear("solid ball without absorption, throughput");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 o(inputs.at(i, 0));
    const glm::dvec3 d(inputs.at(i, 1));
    const glm::dvec3 after(got.at(i, 0));
    const glm::dvec3 across = o - glm::dot(o, d) / glm::dot(d, d) * d;
    const double b = glm::length(across);
    const auto index = static_cast<double>(inputs.at(i, 2).x);
    const Bar::Inputs where = {{"case", i}, {"b", b}, {"index", index}};
    path.near(static_cast<double>(got.at(i, 1).w), 2.0, 0.0, where);
    trapped.near(static_cast<double>(got.at(i, 2).w), 0.0, 0.0, where);
    for (int j = 0; j < 3; ++j) clear.near(static_cast<double>(got.at(i, 1)[j]), 1.0, 0.0, where);
    const double expected = 2.0 * (std::asin(b) - std::asin(b / index));
    const double cosine = glm::dot(after, d) / glm::length(d);
    const double sine = -glm::dot(after, across) / b;
    // Conditioning: asin's slope at the impact parameter, which the hit moves by a few units. The offset of
    // the ray moves it by up to 3e-5 along the normal, which leaves the impact parameter as it is.
    const double slope = 1.0 / std::sqrt(1.0 - b * b);
    if (b > 1e-3) bend.near(std::atan2(sine, cosine), expected, 3e-6 * slope, where);
    way.near(static_cast<double>(got.at(i, 0).w), 2.0 * std::sqrt(1.0 - b * b / (index * index)),
             2e-6 * slope, where);
    if (b > 1e-3)
      plane.near(glm::dot(after, glm::normalize(glm::cross(d, across))), 0.0, 6e-7 / b + 3e-7, where);
    unit.near(glm::length(after), 1.0, 4.0 * unit_roundoff, where);
  }
}

TEST_P(Glass, AbsorptionCountsTheWayThroughGlassOnly) {
  std::vector<double> impacts;
  for (int i = 0; i < 1024; ++i) impacts.push_back(0.0009 * i);
  Bar bar("hollow and solid balls, absorption, relative");
  for (const double inner : {0.0, -0.5}) {
    const Table inputs = parallel_rays(impacts, 1.5, inner, 0.7);
    const Table got = run(ball, inputs);
    for (std::size_t i = 0; i < impacts.size(); ++i) {
      const auto b = static_cast<double>(inputs.at(i, 0).y);
      if (std::abs(b - 0.5) < 1e-3 || std::abs(b - 0.75) < 1e-3) continue;  // where the ray grazes the cavity
      double length = 2.0 * std::sqrt(1.0 - b * b / 2.25);
      if (inner != 0.0 && b < 0.75) length -= 2.0 * std::sqrt(0.25 - b * b / 2.25);
      bar.near(static_cast<double>(got.at(i, 1).x), std::exp(-0.7 * length), 3e-6 * std::exp(-0.7 * length),
               {{"b", b}, {"inner", inner}});
      bar.near(static_cast<double>(got.at(i, 1).y), 1.0, 0.0, {{"b", b}, {"inner", inner}});
      bar.near(static_cast<double>(got.at(i, 1).z), std::exp(-1.4 * length), 6e-6 * std::exp(-1.4 * length),
               {{"b", b}, {"inner", inner}});
    }
  }
}

TEST_P(Glass, IndexOneIsNotThere) {
  Random random(72);
  Table inputs(1 << 16, 3);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const glm::dvec3 d = random_direction(random);
    inputs.at(i, 0) = texel(0.99 * random.uniform() * random_across(random, d) - 3.0 * d);
    inputs.at(i, 1) = texel(d);
    inputs.at(i, 2) = texel({1, i % 2 ? -0.5 : 0.0, 0}, 1);
  }
  const Table got = run(ball, inputs);
  Bar bar("ball of index 1, change of direction");
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    bar.near(glm::distance(glm::dvec3(got.at(i, 0)), glm::dvec3(inputs.at(i, 1))), 0.0, 12.0 * unit_roundoff,
             {{"case", i}});
}

}  // namespace
}  // namespace shadertwin::glass_test
