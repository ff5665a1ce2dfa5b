// hit_quad and hit_triangle: against long double at all scales, without cracks, and at their degenerate ends.
#include <cmath>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::flat_test {
namespace {

class HitQuad : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(HitQuad);
class HitTriangle : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(HitTriangle);

constexpr double far = 1e18;
constexpr double u = unit_roundoff;
const Probe quad{.file = "intersect.glsl", .function = 2, .inputs = 5, .outputs = 2};
const Probe triangle{.file = "intersect.glsl", .function = 3, .inputs = 5, .outputs = 2};
const Probe mesh{.file = "mesh.glsl", .inputs = 8, .outputs = 1};

// A corner and two edges; a triangle is half of it.
struct Case {
  glm::dvec3 origin, direction, corner, edge1, edge2;
  double tmin = 0.0, tmax = far;
};

Table table_of(const std::vector<Case>& cases, bool as_triangle) {
  Table inputs(cases.size(), 5);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    inputs.at(i, 0) = texel(c.origin, c.tmin);
    inputs.at(i, 1) = texel(glm::normalize(c.direction), c.tmax);
    inputs.at(i, 2) = texel(c.corner);
    inputs.at(i, 3) = texel(as_triangle ? c.corner + c.edge1 : c.edge1);
    inputs.at(i, 4) = texel(as_triangle ? c.corner + c.edge2 : c.edge2);
  }
  return inputs;
}

struct Truth {
  long double t, a, b;  // distance, coordinates along the edges
  long double cosine;   // between ray and normal
  double conditioning;  // by how much rounding moves a and b, in units
  Exact normal;
};

Truth truth_of(const Table& inputs, std::size_t i, bool as_triangle) {
  const Exact o = exact(inputs.at(i, 0)) - exact(inputs.at(i, 2));
  const Exact d = exact(inputs.at(i, 1));
  const Exact e1 = as_triangle ? exact(inputs.at(i, 3)) - exact(inputs.at(i, 2)) : exact(inputs.at(i, 3));
  const Exact e2 = as_triangle ? exact(inputs.at(i, 4)) - exact(inputs.at(i, 2)) : exact(inputs.at(i, 4));
  const Exact n = glm::cross(e1, e2);
  const long double n2 = glm::dot(n, n);
  Truth truth{};
  truth.t = -glm::dot(o, n) / glm::dot(d, n);
  const Exact p = o + truth.t * d;
  truth.a = glm::dot(p, glm::cross(e2, n)) / n2;
  truth.b = glm::dot(p, glm::cross(n, e1)) / n2;
  truth.cosine = std::abs(glm::dot(d, n)) / std::sqrt(n2) / glm::length(d);
  truth.normal = n / std::sqrt(n2);
  const long double size = std::max(glm::length(e1), glm::length(e2));
  const long double height = std::sqrt(n2) / size;
  const long double reach =
      glm::length(o) + glm::length(exact(inputs.at(i, 0))) * (as_triangle ? 1.0L : 0.0L) + size;
  truth.conditioning = static_cast<double>(reach / (height * truth.cosine));
  return truth;
}

// Shapes with edges from 1e-3 to 1e4 and aspects up to 1e6, rays from 0.1 to 100 sizes away to points in and
// around them.
std::vector<Case> random_cases(std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> cases;
  for (std::size_t i = 0; i < million; ++i) {
    Case c;
    const double size = random.log_uniform(1e-3, 1e4);
    const double aspect = i % 4 == 0 ? random.log_uniform(1.0, 1e6) : random.uniform(1.0, 3.0);
    const glm::dvec3 along = random_direction(random);
    c.edge1 = size * along;
    c.edge2 =
        size / aspect * glm::normalize(random_across(random, along) + random.uniform(-0.5, 0.5) * along);
    c.corner = random.uniform(0.0, 2.0) * size * random_direction(random);
    const glm::dvec3 target =
        c.corner + random.uniform(-0.3, 1.3) * c.edge1 + random.uniform(-0.3, 1.3) * c.edge2;
    c.origin = target + random.log_uniform(0.1, 100) * size * random_direction(random);
    c.direction = target - c.origin;
    cases.push_back(c);
  }
  return cases;
}

// What both shapes promise, up to what rounding the inputs is worth.
void expect_agreement(const std::string& name, const Table& inputs, const Table& got, bool as_triangle) {
  Bar decision(name + ", hit or miss");
  Bar parameter(name + ", t");
  Bar unit(name + ", length of the normal");
  Bar normal(name + ", direction of the normal");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const Truth truth = truth_of(inputs, i, as_triangle);
    const auto a = static_cast<double>(truth.a);
    const auto b = static_cast<double>(truth.b);
    const double least = as_triangle ? std::min({a, b, 1.0 - a - b}) : std::min({a, b, 1.0 - a, 1.0 - b});
    const bool expected = least > 0.0 && truth.t > 0.0L;
    const Bar::Inputs where = {{"case", i}, {"a", a}, {"b", b}, {"conditioning", truth.conditioning}};
    const double margin = std::max(1e-6, 16.0 * u * truth.conditioning);
    const auto cosine = static_cast<double>(truth.cosine);
    if (std::abs(least) > margin && cosine > 1e-3)
      decision.holds(hit(got, i) == expected, hit(got, i), expected, where);
    if (!hit(got, i) || !expected || cosine < 1e-3) continue;
    const auto t = static_cast<double>(truth.t);
    const double reach = static_cast<double>(glm::length(exact(inputs.at(i, 0)) - exact(inputs.at(i, 2))));
    // A sliver of aspect 1e6 has a plane that is known to 1e6 units less.
    const double slant = as_triangle ? truth.conditioning * 8.0 * u * t : 0.0;
    parameter.near(static_cast<double>(got.at(i, 0).w), t, 1e-6 * (t + reach) / cosine + slant, where);
    unit.near(static_cast<double>(glm::length(exact(got.at(i, 1)))), 1.0, 4.0 * u, where);
    const double sharp = static_cast<double>(glm::length(exact(got.at(i, 1)) - truth.normal));
    if (truth.conditioning < 1e3)
      normal.near(sharp, 0.0, as_triangle ? 16.0 * u * truth.conditioning : 1e-6, where);
  }
}

TEST_P(HitQuad, AgreesWithLongDoubleAtEveryScale) {
  const Table inputs = table_of(random_cases(41), false);
  expect_agreement("hit_quad", inputs, run(quad, inputs), false);
}

TEST_P(HitTriangle, AgreesWithLongDoubleAtEveryScale) {
  const Table inputs = table_of(random_cases(42), true);
  expect_agreement("hit_triangle", inputs, run(triangle, inputs), true);
}

TEST_P(HitQuad, HasNoCrackAlongItsDiagonals) {
  std::vector<Case> cases = random_cases(43);
  Random random(44);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Case& c = cases[i];
    c.edge2 = glm::length(c.edge1) * glm::normalize(random_across(random, c.edge1));
    const double s = random.uniform(0.001, 0.999);
    const glm::dvec3 target =
        i % 2 ? c.corner + s * (c.edge1 + c.edge2) : c.corner + c.edge1 + s * (c.edge2 - c.edge1);
    const glm::dvec3 away = glm::normalize(glm::cross(c.edge1, c.edge2)) + 0.9 * random_direction(random);
    c.origin = target + random.log_uniform(0.1, 10) * glm::length(c.edge1) * away;
    c.direction = target - c.origin;
  }
  const Table got = run(quad, table_of(cases, false));
  Bar bar("hit_quad, rays through the diagonals that miss");
  for (std::size_t i = 0; i < cases.size(); ++i) bar.holds(hit(got, i), hit(got, i), 1.0, {{"case", i}});
}

// Extremes that both shapes share, on the unit square in the plane z = 0 or its half x + y <= 1.
std::vector<Case> extremes() {
  const glm::dvec3 x(1, 0, 0);
  const glm::dvec3 y(0, 1, 0);
  const glm::dvec3 o(0, 0, 0);
  const glm::dvec3 down(0, 0, -1);
  return {{{.25, .25, 2}, down, o, x, y},          // 0: hit from the front
          {{.25, .25, -2}, -down, o, x, y},        // 1: hit from behind
          {{0, 0, 2}, down, o, x, y},              // 2: a corner
          {{1, 0, 2}, down, o, x, y},              // 3: another
          {{0.5, 0, 2}, down, o, x, y},            // 4: an edge
          {{-1, .25, 0}, x, o, x, y},              // 5: in the plane
          {{.25, .25, 2}, -down, o, x, y},         // 6: away
          {{.25, .25, 2}, down, o, x, y, 0, 2},    // 7: t is tmax
          {{.25, .25, 2}, down, o, x, y, 2, far},  // 8: t is tmin
          {{.25, .25, 2}, down, o, x, 2.0 * x},    // 9: no area
          {{.25, .25, 2}, down, o, o, o},          // 10: a point
          {{1.25, .25, 2}, down, o, x, y}};        // 11: beside it
}

void expect_extremes(const Table& got) {
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U}) {
    EXPECT_TRUE(hit(got, i)) << "case " << i;
    EXPECT_EQ(got.at(i, 0).w, 2.0F) << "case " << i;
    EXPECT_EQ(glm::vec3(got.at(i, 1)), glm::vec3(0, 0, 1)) << "case " << i;
  }
  for (std::size_t i = 5; i < 12; ++i) {
    EXPECT_FALSE(hit(got, i)) << "case " << i;
    EXPECT_EQ(got.at(i, 0), glm::vec4(-7)) << "case " << i << ": a miss wrote to the record";
  }
}

TEST_P(HitQuad, ExtremesOfTheTable) {
  expect_extremes(run(quad, table_of(extremes(), false)));
}

TEST_P(HitTriangle, ExtremesOfTheTable) {
  expect_extremes(run(triangle, table_of(extremes(), true)));
}

TEST_P(HitTriangle, ClosedMeshesHaveNoCracks) {
  // Six corners around a point, from inside to anywhere, to the corners themselves, and to points of the
  // edges.
  Random random(45);
  Table inputs(million, 8);
  for (std::size_t i = 0; i < million; ++i) {
    const double scale = random.log_uniform(1e-3, 1e4);
    const glm::dvec3 middle = scale * random.uniform(0.0, 10.0) * random_direction(random);
    for (int corner = 0; corner < 6; ++corner) {
      glm::dvec3 axis(0);
      axis[corner / 2] = corner % 2 ? -1.0 : 1.0;
      inputs.at(i, corner) =
          texel(middle + scale * (random.uniform(0.5, 1.5) * axis + 0.2 * random_direction(random)));
    }
    const glm::dvec3 origin = middle + 0.1 * scale * random_direction(random);
    inputs.at(i, 6) = texel(origin);
    const glm::dvec3 from(inputs.at(i, 6));
    const auto first = static_cast<int>(random.uniform() * 6.0);
    const int second = (first + 2 + static_cast<int>(random.uniform() * 2.0)) % 6;
    const glm::dvec3 p(inputs.at(i, first));
    const glm::dvec3 q(inputs.at(i, second));
    glm::dvec3 d = random_direction(random);
    if (i % 3 == 1) d = p - from;
    if (i % 3 == 2) d = p + random.uniform() * (q - p) - from;
    inputs.at(i, 7) = texel(glm::normalize(d));
  }
  const Table got = run(mesh, inputs);
  Bar cracks("hit_triangle, rays that leave a closed mesh");
  Bar doubles("hit_triangle, rays to a face that hit several");
  for (std::size_t i = 0; i < million; ++i) {
    cracks.holds(got.at(i, 0).x >= 1.0F, static_cast<double>(got.at(i, 0).x), 1.0, {{"case", i}});
    if (i % 3 == 0)
      doubles.holds(got.at(i, 0).x <= 2.0F, static_cast<double>(got.at(i, 0).x), 1.0, {{"case", i}});
  }
}

}  // namespace
}  // namespace shadertwin::flat_test
