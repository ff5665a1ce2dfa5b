// Rays that start on a surface: they don't hit it again going outwards, and find its far side going inwards.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::respawn_test {
namespace {

class SpawnRay : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(SpawnRay);

constexpr std::size_t cases = 400 * 1024;
const Probe sphere{.file = "respawn.glsl", .function = 0, .inputs = 6, .outputs = 2};
const Probe quad{.file = "respawn.glsl", .function = 1, .inputs = 6, .outputs = 2};

struct Placement {
  double scale, translation;
};

TEST_P(SpawnRay, NeverHitsItsOwnSphereOutwards) {
  Bar outwards("spawnRay, outward rays that hit their own sphere");
  Bar inwards("spawnRay, inward rays that don't reach the far side");
  Bar side("spawnRay, rays that start on the wrong side");
  Bar length("spawnRay, chord of inward rays, relative error");
  for (const Placement& placement : {Placement{1, 0}, Placement{1e-3, 0}, Placement{100, 0},
                                     Placement{1e4, 0}, Placement{1, 10}, Placement{1, 1000}}) {
    Random random(51);
    Table inputs(cases, 6);
    for (std::size_t i = 0; i < cases; ++i) {
      const glm::dvec3 center = placement.translation * random_direction(random);
      const glm::dvec3 from = random_direction(random);
      const glm::dvec3 eye = center + placement.scale * random.uniform(1.5, 20.0) * from;
      const glm::dvec3 target =
          center + 0.999 * placement.scale * random_across(random, from) * std::sqrt(random.uniform());
      inputs.at(i, 0) = texel(eye);
      inputs.at(i, 1) = texel(glm::normalize(target - eye));
      inputs.at(i, 2) = texel(center, random.sign() * placement.scale);
      inputs.at(i, 3) = texel(random_direction(random));
    }
    const Table got = run(sphere, inputs);
    for (std::size_t i = 0; i < cases; ++i) {
      const glm::vec4 t = got.at(i, 0);
      if (t.z != 1.0F) continue;
      const Bar::Inputs where = {
          {"scale", placement.scale}, {"translation", placement.translation}, {"case", i}};
      const Exact p = exact(inputs.at(i, 0)) + static_cast<long double>(t.x) * exact(inputs.at(i, 1)) -
                      exact(inputs.at(i, 2));
      const Exact d = exact(inputs.at(i, 3));
      const auto cosine = static_cast<double>(glm::dot(p, d) / glm::length(p));
      const auto start = static_cast<double>(glm::length(exact(got.at(i, 1)) - exact(inputs.at(i, 2))));
      if (std::abs(cosine) < 1e-3) continue;  // which side it leaves to is rounding
      side.holds(cosine > 0.0 ? start > placement.scale : start < placement.scale, start, placement.scale,
                 where);
      if (cosine > 0.0) {
        outwards.holds(t.w == 0.0F, static_cast<double>(t.y), 0.0, where);
      } else if (cosine < -0.1) {
        const double chord = -2.0 * placement.scale * cosine;
        inwards.holds(t.w == 1.0F, static_cast<double>(t.w), 1.0, where);
        // The offset is 3e-5 of the position at most, along the normal.
        const double moved = 4e-5 * (placement.scale + placement.translation) + 2e-5;
        length.near(static_cast<double>(t.y), chord, moved / -cosine + 1e-3 * chord, where);
      }
    }
  }
}

TEST_P(SpawnRay, NeverHitsItsOwnQuad) {
  Bar bar("spawnRay, rays that hit the quad they left");
  for (const double scale : {1e-2, 1.0, 100.0, 1e4}) {
    Random random(52);
    Table inputs(cases, 6);
    for (std::size_t i = 0; i < cases; ++i) {
      const glm::dvec3 along = random_direction(random);
      const glm::dvec3 across = random_across(random, along);
      const glm::dvec3 corner = scale * random_direction(random);
      const glm::dvec3 target = corner + scale * (random.uniform() * along + random.uniform() * across);
      const glm::dvec3 eye = target + scale * random.uniform(0.5, 10.0) * random_direction(random);
      inputs.at(i, 0) = texel(eye);
      inputs.at(i, 1) = texel(glm::normalize(target - eye));
      inputs.at(i, 2) = texel(corner);
      inputs.at(i, 3) = texel(random_direction(random));
      inputs.at(i, 4) = texel(scale * along);
      inputs.at(i, 5) = texel(scale * across);
    }
    const Table got = run(quad, inputs);
    for (std::size_t i = 0; i < cases; ++i) {
      if (got.at(i, 0).z != 1.0F) continue;
      const glm::dvec3 n =
          glm::normalize(glm::cross(glm::dvec3(inputs.at(i, 4)), glm::dvec3(inputs.at(i, 5))));
      // A ray in the plane itself, to within a tenth of a degree, is left to rounding, and so is a hit by
      // one.
      const double leaves = std::abs(glm::dot(n, glm::dvec3(inputs.at(i, 3))));
      const double arrives = std::abs(glm::dot(n, glm::dvec3(inputs.at(i, 1))));
      if (leaves < 2e-3 || arrives < 0.02) continue;
      bar.holds(got.at(i, 0).w == 0.0F, static_cast<double>(got.at(i, 0).y), 0.0,
                {{"scale", scale}, {"case", i}, {"cosine", leaves}});
    }
  }
}

}  // namespace
}  // namespace shadertwin::respawn_test
