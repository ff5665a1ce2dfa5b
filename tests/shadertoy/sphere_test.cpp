// hit_sphere and hit_movingSphere against long double, near and far, small and large, from inside and
// outside.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::sphere_test {
namespace {

class HitSphere : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(HitSphere);
class HitMovingSphere : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(HitMovingSphere);

constexpr double far = 1e18;
constexpr double u = unit_roundoff;
const Probe sphere{.file = "intersect.glsl", .function = 0, .inputs = 5, .outputs = 2};
const Probe moving_sphere{.file = "intersect.glsl", .function = 1, .inputs = 5, .outputs = 2};

struct Case {
  glm::dvec3 origin, direction, center;
  double radius;
  double tmin = 0.0, tmax = far;
};

Table table_of(const std::vector<Case>& cases) {
  Table inputs(cases.size(), 5);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    inputs.at(i, 0) = texel(cases[i].origin, cases[i].tmin);
    inputs.at(i, 1) = texel(glm::normalize(cases[i].direction), cases[i].tmax);
    inputs.at(i, 2) = texel(cases[i].center, cases[i].radius);
  }
  return inputs;
}

struct Roots {
  long double first, last;  // of the line, first < last
  long double miss;         // distance of the centre from the line
  long double distance;     // of the centre from the origin
  long double cosine;       // between the ray and the normal
};

Roots roots_of(const Table& inputs, std::size_t i) {
  const Exact o = exact(inputs.at(i, 0)) - exact(inputs.at(i, 2));
  const Exact d = exact(inputs.at(i, 1));
  const auto radius = std::abs(static_cast<long double>(inputs.at(i, 2).w));
  const long double a = glm::dot(d, d);
  const long double middle = -glm::dot(o, d) / a;
  const Exact closest = o + middle * d;
  const long double miss2 = glm::dot(closest, closest);
  const long double half = std::sqrt(std::max(radius * radius - miss2, 0.0L) / a);
  return {middle - half, middle + half, std::sqrt(miss2), glm::length(o),
          std::sqrt(std::max(1.0L - miss2 / (radius * radius), 0.0L))};
}

// Rays towards and past spheres of radius 1e-3 to 1e3, from 1.5 to 1e5 radii away or from inside.
std::vector<Case> random_cases(std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    const double radius = random.log_uniform(1e-3, 1e3);
    const double distance = i % 4 == 0 ? random.uniform(0.0, 0.99) : random.log_uniform(1.5, 1e5);
    const glm::dvec3 center = radius * random.log_uniform(1e-2, 1e2) * random_direction(random);
    const glm::dvec3 from = random_direction(random);
    glm::dvec3 d = random_direction(random);
    if (i % 4 != 0)
      d = glm::normalize(random.uniform(0.0, 1.2) * random_across(random, from) - distance * from);
    cases.push_back({center + distance * radius * from, d, center, random.sign() * radius});
  }
  return cases;
}

TEST_P(HitSphere, AgreesWithLongDoubleNearAndFar) {
  const Table inputs = table_of(random_cases(31));
  const Table got = run(sphere, inputs);
  Bar decision("hit_sphere, hit or miss");
  Bar surface("hit_sphere, distance of o + t d from the surface over u dist");
  Bar projected("hit_sphere, distance of pos from the surface");
  Bar parameter("hit_sphere, t");
  Bar unit("hit_sphere, length of the normal");
  Bar normal("hit_sphere, direction of the normal");
  for (std::size_t i = 0; i < million; ++i) {
    const Roots roots = roots_of(inputs, i);
    const auto r = static_cast<double>(inputs.at(i, 2).w);
    const double radius = std::abs(r);
    const auto distance = static_cast<double>(roots.distance);
    const Bar::Inputs where = {{"case", i},
                               {"radius", r},
                               {"distance / radius", distance / radius},
                               {"miss / radius", static_cast<double>(roots.miss) / radius}};
    const double margin = std::abs(static_cast<double>(roots.miss) / radius - 1.0);
    const bool clear = margin > 8.0 * u * std::max(distance / radius, 1.0);
    const bool expected = static_cast<double>(roots.miss) < radius && roots.last > 0.0L;
    if (clear) decision.holds(hit(got, i) == expected, hit(got, i), expected, where);
    if (!hit(got, i) || !clear || !expected) continue;
    const auto t = static_cast<double>(got.at(i, 0).w);
    const double reach = std::max(distance, radius);
    const Exact p = exact(inputs.at(i, 0)) + static_cast<long double>(t) * exact(inputs.at(i, 1)) -
                    exact(inputs.at(i, 2));
    surface.near(static_cast<double>(glm::length(p)), radius, 8.0 * u * reach, where);
    const Exact pos = exact(got.at(i, 0)) - exact(inputs.at(i, 2));
    projected.near(static_cast<double>(glm::length(pos)), radius,
                   4.0 * u * (static_cast<double>(glm::length(exact(inputs.at(i, 2)))) + radius), where);
    const long double root = roots.first > 0.0L ? roots.first : roots.last;
    const auto cosine = static_cast<double>(roots.cosine);
    parameter.near(t, static_cast<double>(root), 8.0 * u * reach / cosine, where);
    unit.near(static_cast<double>(glm::length(exact(got.at(i, 1)))), 1.0, 4.0 * u, where);
    const Exact outward = (exact(inputs.at(i, 0)) + root * exact(inputs.at(i, 1)) - exact(inputs.at(i, 2))) /
                          static_cast<long double>(r);
    normal.near(static_cast<double>(glm::length(exact(got.at(i, 1)) - outward)), 0.0,
                8.0 * u * (1.0 + reach / (radius * cosine)), where);
  }
}

TEST_P(HitSphere, NegativeRadiusFlipsTheNormalAndNothingElse) {
  std::vector<Case> cases = random_cases(32);
  cases.resize(std::size_t{1} << 16);
  for (Case& c : cases) c.radius = std::abs(c.radius);
  const Table solid = run(sphere, table_of(cases));
  for (Case& c : cases) c.radius = -c.radius;
  const Table hollow = run(sphere, table_of(cases));
  Bar bar("hit_sphere, negative radius");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    bar.holds(solid.at(i, 0) == hollow.at(i, 0) && hit(solid, i) == hit(hollow, i),
              static_cast<double>(hollow.at(i, 0).w), static_cast<double>(solid.at(i, 0).w), {{"case", i}});
    if (!hit(solid, i)) continue;
    for (int j = 0; j < 3; ++j)
      bar.near(static_cast<double>(hollow.at(i, 1)[j]), -static_cast<double>(solid.at(i, 1)[j]), 0.0,
               {{"case", i}});
  }
}

TEST_P(HitSphere, ExtremesOfTheTable) {
  const glm::dvec3 x(1, 0, 0);
  const std::vector<Case> cases = {
      {{-5, 0, 0}, x, {0, 0, 0}, 1},                         // 0: through the centre
      {{0, 0, 0}, x, {0, 0, 0}, 1},                          // 1: from the centre
      {{-1, 0, 0}, x, {0, 0, 0}, 1, 1e-4},                   // 2: from the surface inwards: the far root
      {{-1.000001, 0, 0}, x, {0, 0, 0}, 1, 1e-4},            // 3: from just outside, the near root below tmin
      {{-0.999999, 0, 0}, x, {0, 0, 0}, 1, 1e-4},            // 4: from just inside
      {{1, 0, 0}, x, {0, 0, 0}, 1, 1e-4},                    // 5: from the surface outwards
      {{-5, 0, 0}, x, {0, 0, 0}, 0},                         // 6: radius 0
      {{-5, 2, 0}, x, {0, 0, 0}, 1},                         // 7: past it
      {{5, 0, 0}, x, {0, 0, 0}, 1},                          // 8: away from it
      {{-5, 0, 0}, x, {0, 0, 0}, 1, 0, 4},                   // 9: t is tmax: an open interval
      {{-5, 0, 0}, x, {0, 0, 0}, 1, 4, far},                 // 10: t is tmin: the far root
      {{-5, 0, 0}, x, {0, 0, 0}, 1, 6, far},                 // 11: both roots before tmin
      {{-5, 0, 0}, x, {0, 0, 0}, 1, 4.5, 5.5},               // 12: inside the interval all the way
      {{0, 1, 0}, {0, -1, 0}, {0, -1000, 0}, 1000},          // 13: the ground from a metre above
      {{0, 0.001, 0}, {1, -0.001, 0}, {0, -1000, 0}, 1000},  // 14: the ground, grazing
      {{-5, 0, 0}, x, {0, 0, 0}, -1},                        // 15: a cavity from outside
      {{0, 0, 0}, x, {0, 0, 0}, -1},                         // 16: a cavity from within
  };
  const Table inputs = table_of(cases);
  const Table got = run(sphere, inputs);
  const auto t = [&](std::size_t i) { return static_cast<double>(got.at(i, 0).w); };
  EXPECT_NEAR(t(0), 4, 4e-7);
  EXPECT_EQ(t(1), 1);
  EXPECT_NEAR(t(2), 2, 4e-7);
  EXPECT_NEAR(t(3), 2.000001, 4e-7);
  EXPECT_NEAR(t(4), 1.999999, 4e-7);
  for (const std::size_t miss : {5U, 6U, 7U, 8U, 9U, 11U, 12U}) {
    EXPECT_FALSE(hit(got, miss)) << "case " << miss;
    EXPECT_EQ(got.at(miss, 0), glm::vec4(-7)) << "case " << miss << ": a miss wrote to the record";
  }
  EXPECT_NEAR(t(10), 6, 4e-7);
  EXPECT_NEAR(t(13), 1, 8.0 * u * 1001);
  const Roots grazing = roots_of(inputs, 14);
  EXPECT_NEAR(t(14), static_cast<double>(grazing.first),
              8.0 * u * 1000 / static_cast<double>(grazing.cosine));
  EXPECT_EQ(glm::vec3(got.at(0, 1)), glm::vec3(-1, 0, 0));
  EXPECT_EQ(glm::vec3(got.at(1, 1)), glm::vec3(1, 0, 0));
  EXPECT_EQ(glm::vec3(got.at(15, 1)), glm::vec3(1, 0, 0));
  EXPECT_EQ(glm::vec3(got.at(16, 1)), glm::vec3(-1, 0, 0));
}

TEST_P(HitSphere, TangentsGiveFiniteAndConsistentNormals) {
  std::vector<Case> cases;
  Random random(33);
  for (int i = 0; i < 4096; ++i) {
    const glm::dvec3 d = random_direction(random);
    const glm::dvec3 side = random_across(random, d);
    const double radius = random.log_uniform(1e-3, 1e3);
    cases.push_back({radius * (side - random.log_uniform(1.0, 1e3) * d), d, {0, 0, 0}, radius});
  }
  const Table got = run(sphere, table_of(cases));
  Bar bar("hit_sphere, tangents");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto length = static_cast<double>(glm::length(exact(got.at(i, 1))));
    bar.holds(hit(got, i) ? std::abs(length - 1.0) <= 4.0 * u : got.at(i, 0) == glm::vec4(-7), length, 1.0,
              {{"case", i}});
  }
}

TEST_P(HitMovingSphere, IsTheSphereAtTheRaysTime) {
  Random random(34);
  Table moving(million, 5);
  Table still(million, 5);
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 c0 = 5.0 * random_direction(random);
    const glm::dvec3 c1 = c0 + random.log_uniform(1e-3, 10) * random_direction(random);
    const double t0 = random.uniform(-2, 2);
    const double t1 = t0 + random.log_uniform(1e-3, 5);
    const double f = i % 8 == 0 ? 0.0 : i % 8 == 1 ? 1.0 : i % 8 == 2 ? 0.5 : random.uniform();
    const double time = i % 8 == 3 ? t0 - 1.0 : i % 8 == 4 ? t1 + 1.0 : t0 + f * (t1 - t0);
    const double radius = random.sign() * random.log_uniform(0.01, 3);
    moving.at(i, 2) = texel(c0, radius);
    moving.at(i, 3) = texel(c1, time);
    moving.at(i, 4) = texel({t0, t1, 0});
    const auto p0 = glm::dvec3(moving.at(i, 2));
    const auto p1 = glm::dvec3(moving.at(i, 3));
    const auto begin = static_cast<double>(moving.at(i, 4).x);
    const auto end = static_cast<double>(moving.at(i, 4).y);
    const double part =
        std::clamp((static_cast<double>(moving.at(i, 3).w) - begin) / (end - begin), 0.0, 1.0);
    still.at(i, 2) = texel(p0 + part * (p1 - p0), radius);
    const glm::dvec3 eye = 20.0 * random_direction(random);
    const glm::dvec3 target = glm::dvec3(still.at(i, 2)) + 0.7 * std::abs(radius) * random_direction(random);
    moving.at(i, 0) = still.at(i, 0) = texel(eye);
    moving.at(i, 1) = still.at(i, 1) = texel(glm::normalize(target - eye), far);
  }
  const Table got = run(moving_sphere, moving);
  const Table expected = run(sphere, still);
  Bar bar("hit_movingSphere, t against hit_sphere at c(t)");
  Bar ends("hit_movingSphere, position at the ends of the shutter");
  for (std::size_t i = 0; i < million; ++i) {
    const Roots roots = roots_of(still, i);
    const auto radius = std::abs(static_cast<double>(still.at(i, 2).w));
    // The centre is known to 4 u of its coordinates; that moves t by as much over the cosine. The fraction of
    // the shutter carries the rounding of the time itself.
    const double travel = glm::distance(glm::dvec3(moving.at(i, 2)), glm::dvec3(moving.at(i, 3)));
    const double duration = static_cast<double>(moving.at(i, 4).y) - static_cast<double>(moving.at(i, 4).x);
    const double shift = u * (4.0 * 15.0 + 2.0 * travel * 3.0 / duration);
    const Bar::Inputs where = {
        {"case", i}, {"radius", radius}, {"time", moving.at(i, 3).w}, {"duration", duration}};
    if (hit(got, i) != hit(expected, i)) {
      bar.holds(false, hit(got, i), hit(expected, i), where);
      continue;
    }
    if (!hit(got, i)) continue;
    bar.near(static_cast<double>(got.at(i, 0).w), static_cast<double>(expected.at(i, 0).w),
             (shift + 8.0 * u * 25.0) / static_cast<double>(roots.cosine), where);
    if (i % 8 == 0 || i % 8 == 3)
      ends.near(static_cast<double>(got.at(i, 0).w), static_cast<double>(expected.at(i, 0).w), 0.0, where);
  }
}

TEST_P(HitMovingSphere, StandsStillWithoutMotionOrDuration) {
  Random random(35);
  std::vector<Case> cases = random_cases(35);
  cases.resize(std::size_t{1} << 16);
  Table inputs = table_of(cases);
  const Table expected = run(sphere, inputs);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool motionless = i % 2 == 0;
    inputs.at(i, 3) = motionless ? texel(glm::dvec3(inputs.at(i, 2)), random.uniform())
                                 : texel({1, 2, 3}, random.uniform());
    inputs.at(i, 4) = motionless ? texel({0, 1, 0}) : texel({0.5, 0.5, 0});
  }
  const Table got = run(moving_sphere, inputs);
  Bar bar("hit_movingSphere without motion, difference from hit_sphere");
  for (std::size_t i = 0; i < cases.size(); ++i)
    bar.holds(got.at(i, 0) == expected.at(i, 0) && got.at(i, 1) == expected.at(i, 1),
              static_cast<double>(got.at(i, 0).w), static_cast<double>(expected.at(i, 0).w), {{"case", i}});
}

}  // namespace
}  // namespace shadertwin::sphere_test
