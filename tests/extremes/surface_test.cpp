// Rays that leave a surface, from shapes of all sizes wherever they are: none may hit what it leaves.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::surface_test {
namespace {

class Surfaces : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Surfaces);

const std::vector<double> radii = {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6};
const std::vector<double> shifts = {0.0, 1.0, 100.0, 1e5};
constexpr std::size_t cases = std::size_t{1} << 14;

Probe respawn(int function) {
  return {.file = "respawn.glsl", .function = function, .inputs = 6, .outputs = 2};
}

// How far float coordinates of a shape are apart, for a shape and its place.
double spacing(double size, double shift) {
  return unit_roundoff * 2.0 * (size + shift);
}

// A quarter of the balls are seen where they touch an axis of the world: the ball that is a ground.
TEST_P(Surfaces, OfBallsAreLeftAtEverySizeAndPlace) {
  Bar side("rays from balls that start on the wrong side");
  Bar again("rays from balls, second hits");
  Bar near("rays from balls, distance of the start from the surface over the size of the numbers");
  for (const double radius : radii)
    for (const double shift : shifts) {
      if (radius < 100.0 * spacing(radius, shift)) continue;  // no ball any more: a few floats
      Random random(301);
      Table inputs(cases, 6);
      for (std::size_t i = 0; i < cases; ++i) {
        const glm::dvec3 up = i % 4 == 0 ? glm::dvec3(0, 1, 0) : random_direction(random);
        const glm::dvec3 at = shift * random_direction(random);
        const double size = std::min(radius, 1.0);
        const glm::dvec3 target = at + 0.3 * size * random.uniform() * random_across(random, up);
        const glm::dvec3 eye =
            at + size * random.uniform(1.0, 5.0) * glm::normalize(up + 0.9 * random_direction(random));
        inputs.at(i, 0) = texel(eye);
        inputs.at(i, 1) = texel(glm::normalize(target - eye));
        inputs.at(i, 2) = texel(at - radius * up, random.sign() * radius);
        inputs.at(i, 3) = texel(random_direction(random));
        if (i % 8 < 4) {  // grazing: at an angle of any size to the surface
          const double lift = random.sign() * random.log_uniform(1e-5, 1.0);
          inputs.at(i, 3) = texel(glm::normalize(random_across(random, up) + lift * up));
        }
      }
      const Table got = run(respawn(0), inputs);
      for (std::size_t i = 0; i < cases; ++i) {
        const glm::vec4 t = got.at(i, 0);
        if (t.z != 1.0F) continue;
        const auto r = std::abs(static_cast<double>(inputs.at(i, 2).w));
        const Bar::Inputs where = {{"radius", r}, {"shift", shift}, {"case", i}};
        // The shader says to which side of its normal the ray leaves; a negative radius turns that around.
        const bool outwards = (got.at(i, 1).w > 0.0F) == (inputs.at(i, 2).w > 0.0F);
        const auto start = static_cast<double>(glm::length(exact(got.at(i, 1)) - exact(inputs.at(i, 2))));
        side.holds(outwards ? start > r : start < r, start, r, where);
        again.holds((t.w == 1.0F) == !outwards, t.w, !outwards, where);
        near.near(start / r, 1.0, 2e-6 * (1.0 + (r + shift) / r), where);
      }
    }
}

TEST_P(Surfaces, OfQuadsAndTrianglesAreLeftAtEverySizeAndPlace) {
  Bar again("rays from flat shapes that hit them again");
  Bar near("rays from flat shapes, distance of the start from the plane over the size of the numbers");
  for (const double size : {1e-3, 0.1, 10.0, 1e3, 1e5})
    for (const double shift : shifts) {
      if (size < 100.0 * spacing(size, shift)) continue;
      Random random(302);
      Table quads(cases, 6);
      for (std::size_t i = 0; i < cases; ++i) {
        // Every fourth along the axes, as floors and walls are.
        const bool aligned = i % 4 == 0;
        const glm::dvec3 edge1 = size * (aligned ? glm::dvec3(1, 0, 0) : random_direction(random));
        const glm::dvec3 edge2 = size * (aligned ? glm::dvec3(0, 0, -1) : random_across(random, edge1));
        const glm::dvec3 n = glm::normalize(glm::cross(edge1, edge2));
        const glm::dvec3 corner =
            shift * random_direction(random) - (i % 8 == 0 ? 0.5 * edge1 : glm::dvec3(0));
        const double part = random.uniform();
        const glm::dvec3 target = corner + part * edge1 + (1.0 - part) * random.uniform() * edge2;
        const glm::dvec3 eye =
            target + size * random.uniform(0.5, 10.0) * glm::normalize(n + 0.9 * random_direction(random));
        quads.at(i, 0) = texel(eye);
        quads.at(i, 1) = texel(glm::normalize(target - eye));
        quads.at(i, 2) = texel(corner);
        quads.at(i, 3) = texel(
            glm::normalize(random_across(random, n) + random.sign() * random.log_uniform(1e-4, 10.0) * n));
        quads.at(i, 4) = texel(edge1);
        quads.at(i, 5) = texel(edge2);
      }
      Table triangles = quads;
      for (std::size_t i = 0; i < cases; ++i)
        for (const int edge : {4, 5}) triangles.at(i, edge) += triangles.at(i, 2);
      for (const bool triangle : {false, true}) {
        const Table& inputs = triangle ? triangles : quads;
        const Table got = run(respawn(triangle ? 2 : 1), inputs);
        for (std::size_t i = 0; i < cases; ++i) {
          if (got.at(i, 0).z != 1.0F) continue;
          const Bar::Inputs where = {{"triangle", triangle}, {"size", size}, {"shift", shift}, {"case", i}};
          again.holds(got.at(i, 0).w == 0.0F, got.at(i, 0).y, 0.0, where);
          const Exact origin = triangle ? exact(inputs.at(i, 2)) : Exact(0);
          const Exact n =
              glm::normalize(glm::cross(exact(inputs.at(i, 4)) - origin, exact(inputs.at(i, 5)) - origin));
          const auto away = static_cast<double>(glm::dot(exact(got.at(i, 1)) - exact(inputs.at(i, 2)), n));
          near.near(away / size, 0.0, 4e-6 * (1.0 + shift / size), where);
        }
      }
    }
}

}  // namespace
}  // namespace shadertwin::surface_test
