// Rays and shapes for intersection tests, and what long double makes of them.
#pragma once

#include <glm/glm.hpp>

#include "tests/shadertoy/probe.h"
#include "tests/shadertoy/random.h"

namespace shadertwin {

using Exact = glm::tvec3<long double>;

inline Exact exact(const glm::vec4& v) {
  return {static_cast<long double>(v.x), static_cast<long double>(v.y), static_cast<long double>(v.z)};
}

inline glm::dvec3 random_direction(Random& random) {
  for (;;) {
    const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double length2 = glm::dot(v, v);
    if (length2 > 1e-3 && length2 < 1.0) return v / std::sqrt(length2);
  }
}

// A unit vector at right angles to d.
inline glm::dvec3 random_across(Random& random, const glm::dvec3& d) {
  return glm::normalize(glm::cross(d, random_direction(random)));
}

// What intersect.glsl says of a case.
inline bool hit(const Table& got, std::size_t i) {
  return got.at(i, 1).w == 1.0F;
}

inline glm::vec4 texel(const glm::dvec3& v, double w = 0.0) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

}  // namespace shadertwin
