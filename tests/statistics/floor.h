// ROOM 0 of rooms.glsl: a floor under a light, whose radiance is known.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace shadertwin {

struct Floor {
  double width, depth, height, albedo, radiance;
};

// Irradiance over radiance of a polygon with corners v, seen from the origin by a surface of normal n:
// Lambert's formula, a sum over the edges.
inline double lambert(const std::vector<glm::dvec3>& v, const glm::dvec3& n) {
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
inline double closed_form(const Floor& f, double x, double z) {
  const double a = f.width / 2.0;
  const double b = f.depth / 2.0;
  const double irradiance = lambert({{-a - x, f.height, -b - z},
                                     {a - x, f.height, -b - z},
                                     {a - x, f.height, b - z},
                                     {-a - x, f.height, b - z}},
                                    {0, 1, 0});
  return f.albedo / std::numbers::pi * f.radiance * irradiance;
}

inline std::string glsl(double value) {
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint << value;
  return text.str();
}

// What rooms.glsl is told of it.
inline std::vector<std::pair<std::string, std::string>> floor_defines(const Floor& floor) {
  return {{"ROOM", "0"},
          {"ALBEDO", glsl(floor.albedo)},
          {"RADIANCE", glsl(floor.radiance)},
          {"LIGHT_HEIGHT", glsl(floor.height)},
          {"LIGHT_SIZE", "vec2(" + glsl(floor.width) + ", " + glsl(floor.depth) + ")"}};
}

}  // namespace shadertwin
