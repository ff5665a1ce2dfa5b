// Cases of scatter.glsl: a ray that meets a surface of a material.
#pragma once

#include <cmath>

#include "tests/shadertoy/shapes.h"

namespace shadertwin::scattering {

enum Type { diffuse, metal, dielectric, conductor, plastic };

inline Probe probe(int function, std::vector<std::pair<std::string, std::string>> defines = {}) {
  return {
      .file = "scatter.glsl", .function = function, .inputs = 6, .outputs = 3, .defines = std::move(defines)};
}

struct Case {
  Type type = diffuse;
  glm::dvec3 direction{0, 0, -1}, normal{0, 0, 1};
  double roughness = 0.5;
  glm::dvec3 color{0.5};
  double index = 1.5;
  glm::dvec4 xi{0.5};
  glm::dvec3 extra{0};
  double way = 1;
};

inline glm::dvec3 vec(const glm::vec4& v) {
  return glm::dvec3(v);
}

inline Table table_of(const std::vector<Case>& cases) {
  Table inputs(cases.size(), 6);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    inputs.at(i, 0) = texel(glm::normalize(c.direction), c.type);
    inputs.at(i, 1) = texel(glm::normalize(c.normal), c.roughness);
    inputs.at(i, 2) = texel(c.color, c.index);
    inputs.at(i, 3) = glm::vec4(c.xi);
    inputs.at(i, 4) = texel(c.extra);
    inputs.at(i, 5) = texel(glm::dvec3(1, 2, 3) - c.way * vec(inputs.at(i, 0)));
  }
  return inputs;
}

inline glm::dvec4 random_xi(Random& random) {
  return {random.uniform(), random.uniform(), random.uniform(), random.uniform()};
}

// Arrives at the front of a random surface with a cosine of all scales.
inline Case arriving(Random& random, Type type, double least = 1e-3) {
  Case c;
  c.type = type;
  c.normal = random_direction(random);
  const double cosine = random.log_uniform(least, 1.0);
  c.direction = std::sqrt(1.0 - cosine * cosine) * random_across(random, c.normal) - cosine * c.normal;
  c.xi = random_xi(random);
  return c;
}

}  // namespace shadertwin::scattering
