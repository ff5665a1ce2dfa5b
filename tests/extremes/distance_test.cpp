// Shapes seen from far away, at a grazing angle, and of every size.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::distance_test {
namespace {

class Distance : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Distance);

constexpr double far = 1e18;
constexpr double u = unit_roundoff;
constexpr std::size_t cases = std::size_t{1} << 14;

Probe intersect(int function) {
  return {.file = "intersect.glsl", .function = function, .inputs = 5, .outputs = 2};
}

// The largest error of t over the radius grows with the distance, and no faster.
TEST_P(Distance, BallsAreHitAtTheirPlaceFromTenToAMillionRadii) {
  Bar decision("balls from afar, hit or miss");
  Bar surface("balls from afar, distance of the hit from the ball over 4 u of its radius and place");
  Bar normal("balls from afar, direction of the normal");
  Bar growth("balls from afar, error of t over u times the distance");
  for (const double radius : {1e-3, 1.0, 1e3, 1e6})
    for (double radii = 10.0; radii <= 1e6; radii *= 10.0) {
      Random random(311);
      Table inputs(cases, 5);
      for (std::size_t i = 0; i < cases; ++i) {
        const glm::dvec3 from = random_direction(random);
        const glm::dvec3 eye = radii * radius * from;
        const glm::dvec3 target = radius * random.uniform(0.0, 1.2) * random_across(random, from);
        inputs.at(i, 0) = texel(eye);
        inputs.at(i, 1) = texel(glm::normalize(target - eye), far);
        inputs.at(i, 2) = texel({0, 0, 0}, random.sign() * radius);
      }
      const Table got = run(intersect(0), inputs);
      for (std::size_t i = 0; i < cases; ++i) {
        const Exact o = exact(inputs.at(i, 0));
        const Exact d = glm::normalize(exact(inputs.at(i, 1)));
        const auto r = std::abs(static_cast<long double>(inputs.at(i, 2).w));
        const long double middle = -glm::dot(o, d);
        const auto miss = static_cast<double>(glm::length(o + middle * d) / r);
        const Bar::Inputs where = {{"radius", radius}, {"radii", radii}, {"case", i}, {"miss", miss}};
        // What the direction's rounding is worth at that distance.
        if (std::abs(miss - 1.0) < 8.0 * u * radii) continue;
        decision.holds(hit(got, i) == (miss < 1.0), hit(got, i), miss < 1.0, where);
        if (!hit(got, i) || miss > 1.0) continue;
        surface.near(static_cast<double>(glm::length(exact(got.at(i, 0))) / r), 1.0, 4.0 * u, where);
        const long double cosine = std::sqrt(1.0L - static_cast<long double>(miss) * miss);
        const long double t = middle - r * cosine;
        const auto slope = static_cast<double>(cosine);
        growth.near(got.at(i, 0).w, static_cast<double>(t), 8.0 * u * static_cast<double>(t) / slope, where);
        const Exact outwards = (o + t * d) / static_cast<long double>(inputs.at(i, 2).w);
        normal.near(static_cast<double>(glm::length(exact(got.at(i, 1)) - outwards)), 0.0,
                    8.0 * u * radii / slope, where);
      }
    }
}

// The angle between the ray and the surface falls to 1e-7: nothing but t may lose its digits, by that factor.
TEST_P(Distance, GrazingRaysHitFlatShapesInTheirPlane) {
  Bar plane("grazing rays, distance of the hit from the plane over u times its size and place");
  Bar parameter("grazing rays, error of t times the sine over u");
  Bar aim("grazing rays that miss");
  Bar finite("grazing rays, results that are no numbers");
  for (double sine = 1.0; sine >= 1e-7; sine *= 0.1)
    for (const int function : {2, 3}) {
      Random random(312);
      Table inputs(cases, 5);
      for (std::size_t i = 0; i < cases; ++i) {
        const glm::dvec3 edge1 = random_direction(random);
        const glm::dvec3 edge2 = random_across(random, edge1);
        const glm::dvec3 n = glm::cross(edge1, edge2);
        const glm::dvec3 corner = random_direction(random);
        const double part = random.uniform(0.1, 0.6);
        const glm::dvec3 target = corner + part * edge1 + (0.9 - part) * edge2;
        const double turn = random.uniform(0.0, 6.28);
        const glm::dvec3 along = std::cos(turn) * edge1 + std::sin(turn) * edge2;
        const glm::dvec3 d = std::sqrt(1.0 - sine * sine) * along - sine * n;
        inputs.at(i, 0) = texel(target - 3.0 * d);
        inputs.at(i, 1) = texel(d, far);
        inputs.at(i, 2) = texel(corner);
        inputs.at(i, 3) = texel(function == 2 ? edge1 : corner + edge1);
        inputs.at(i, 4) = texel(function == 2 ? edge2 : corner + edge2);
      }
      const Table got = run(intersect(function), inputs);
      for (std::size_t i = 0; i < cases; ++i) {
        const Bar::Inputs where = {{"sine", sine}, {"triangle", function == 3}, {"case", i}};
        for (int j = 0; j < 4; ++j)
          finite.holds(std::isfinite(got.at(i, 0)[j]) && std::isfinite(got.at(i, 1)[j]), got.at(i, 0)[j], 0.0,
                       where);
        // Aimed a tenth of an edge into the shape at least: flatter, rounding may move the hit past the edge.
        if (sine > 1e-5) aim.holds(hit(got, i), hit(got, i), 1.0, where);
        if (!hit(got, i)) continue;
        const Exact corner = exact(inputs.at(i, 2));
        const Exact origin = function == 2 ? Exact(0) : corner;
        const Exact n =
            glm::normalize(glm::cross(exact(inputs.at(i, 3)) - origin, exact(inputs.at(i, 4)) - origin));
        plane.near(static_cast<double>(glm::dot(exact(got.at(i, 0)) - corner, n)), 0.0, 16.0 * u, where);
        const Exact d = exact(inputs.at(i, 1));
        const long double slope = glm::dot(d, n);
        const auto t = static_cast<double>(glm::dot(corner - exact(inputs.at(i, 0)), n) / slope);
        if (std::abs(static_cast<double>(slope)) > 0.5 * sine)
          parameter.near(got.at(i, 0).w, t, 64.0 * u / std::abs(static_cast<double>(slope)), where);
      }
    }
}

}  // namespace
}  // namespace shadertwin::distance_test
