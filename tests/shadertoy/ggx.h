// GGX in double, from the papers: the oracle of the microfacet tests. Directions are in the frame of the
// normal.
#pragma once

#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>

namespace shadertwin::ggx {

using std::numbers::pi;

// Walter et al. 2007, equation 33, from the angle between h and the normal.
inline double distribution(const glm::dvec3& h, double alpha) {
  if (h.z <= 0.0) return 0.0;
  const double tangent2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
  const double length2 = glm::dot(h, h);
  const double cosine2 = h.z * h.z / length2;
  const double sum = alpha * alpha + tangent2;
  return alpha * alpha / (pi * cosine2 * cosine2 * sum * sum) / (length2 * length2);
}

// Heitz 2014, equation 72.
inline double lambda(double cosine, double alpha) {
  const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}
inline double masking(double cosine, double alpha) {
  return 1.0 / (1.0 + lambda(cosine, alpha));
}
inline double masking_shadowing(double v, double l, double alpha) {
  return 1.0 / (1.0 + lambda(v, alpha) + lambda(l, alpha));
}

// Density per solid angle of reflected directions that visible normals give (Heitz 2018, equations 3 and 17).
inline double visible_pdf(const glm::dvec3& v, const glm::dvec3& l, double alpha) {
  const glm::dvec3 h = glm::normalize(v + l);
  return masking(v.z, alpha) * distribution(h, alpha) / (4.0 * v.z);
}

// A visible normal (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1, in words: a
// disk of which the lower half is squeezed to what can be seen of it).
inline glm::dvec3 visible_normal(const glm::dvec3& v, double alpha, double u1, double u2) {
  const glm::dvec3 w = glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
  const double across = std::hypot(w.x, w.y);
  const glm::dvec3 t1 = across > 1e-12 ? glm::dvec3(-w.y, w.x, 0.0) / across : glm::dvec3(1, 0, 0);
  const glm::dvec3 t2 = glm::cross(w, t1);
  const double r = std::sqrt(u1);
  const double a = r * std::cos(2.0 * pi * u2);
  const double s = 0.5 * (1.0 + w.z);
  const double b = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - a * a)) + s * r * std::sin(2.0 * pi * u2);
  const glm::dvec3 n = a * t1 + b * t2 + std::sqrt(std::max(0.0, 1.0 - a * a - b * b)) * w;
  return glm::normalize(glm::dvec3(alpha * n.x, alpha * n.y, std::max(1e-12, n.z)));
}

inline glm::dvec3 direction(double cosine) {
  return {std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), 0.0, cosine};
}

// Directional albedo of the lobe with reflectance F(VoH), by a grid of n x n visible normals.
inline double albedo(double cosine, double alpha, const std::function<double(double)>& reflectance,
                     int n = 400) {
  const glm::dvec3 v = direction(cosine);
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const glm::dvec3 h = visible_normal(v, alpha, (i + 0.5) / n, (j + 0.5) / n);
      const double voh = glm::dot(v, h);
      const double l = 2.0 * voh * h.z - v.z;
      if (l > 0.0) sum += reflectance(voh) * masking_shadowing(v.z, l, alpha) / masking(v.z, alpha);
    }
  return sum / n / n;
}

}  // namespace shadertwin::ggx
