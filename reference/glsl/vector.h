// Geometry and matrices, in the order in which Mesa adds: dot is x + (y + (z + w)), a matrix times a vector
// adds its columns from the left.
#pragma once

#include "reference/glsl/common.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

// --- Geometry ---------------------------------------------------------------

SHADERTWIN_INLINE Float dot(Float a, Float b) {
  return a * b;
}
SHADERTWIN_INLINE Float dot(vec2 a, vec2 b) {
  return a.x * b.x + a.y * b.y;
}
SHADERTWIN_INLINE Float dot(vec3 a, vec3 b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
SHADERTWIN_INLINE Float dot(vec4 a, vec4 b) {
  return a.x * b.x + (a.y * b.y + (a.z * b.z + a.w * b.w));
}

SHADERTWIN_INLINE vec3 cross(vec3 a, vec3 b) {
  return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// Mesa squares here too, so that what is below 2^-63 or above 2^64 has no length.
SHADERTWIN_INLINE Float length(Float x) {
  return std::sqrt(x * x);
}
SHADERTWIN_INLINE Float distance(Float a, Float b) {
  return std::fabs(a - b);
}
SHADERTWIN_INLINE Float normalize(Float x) {
  SHADERTWIN_PROBE(x == 0, normalize_zero);
  return sign(x);
}
SHADERTWIN_INLINE Float faceforward(Float n, Float incident, Float reference) {
  return reference * incident < 0 ? n : -n;
}
SHADERTWIN_INLINE Float reflect(Float incident, Float n) {
  return incident - Float(2) * (n * incident * n);
}
SHADERTWIN_INLINE Float refract(Float incident, Float n, Float eta) {
  const Float d = n * incident;
  const Float k = Float(1) - eta * (eta * (Float(1) - d * d));
  return k < 0 ? Float(0) : eta * incident - (eta * d + std::sqrt(k)) * n;
}

#define SHADERTWIN_GEOMETRY(N)                                                        \
  SHADERTWIN_INLINE Float length(vec##N v) {                                          \
    return std::sqrt(dot(v, v));                                                      \
  }                                                                                   \
  SHADERTWIN_INLINE Float distance(vec##N a, vec##N b) {                              \
    return length(a - b);                                                             \
  }                                                                                   \
  SHADERTWIN_INLINE vec##N normalize(vec##N v) {                                      \
    const Float square = dot(v, v);                                                   \
    SHADERTWIN_PROBE(square == 0, normalize_zero);                                    \
    return v * (Float(1) / std::sqrt(square));                                        \
  }                                                                                   \
  SHADERTWIN_INLINE vec##N faceforward(vec##N n, vec##N incident, vec##N reference) { \
    return dot(reference, incident) < 0 ? n : -n;                                     \
  }                                                                                   \
  SHADERTWIN_INLINE vec##N reflect(vec##N incident, vec##N n) {                       \
    return incident - (Float(2) * dot(n, incident)) * n;                              \
  }                                                                                   \
  SHADERTWIN_INLINE vec##N refract(vec##N incident, vec##N n, Float eta) {            \
    const Float d = dot(n, incident);                                                 \
    const Float k = Float(1) - eta * (eta * (Float(1) - d * d));                      \
    return k < 0 ? vec##N(0) : eta * incident - (eta * d + std::sqrt(k)) * n;         \
  }
SHADERTWIN_GEOMETRY(2)
SHADERTWIN_GEOMETRY(3)
SHADERTWIN_GEOMETRY(4)
#undef SHADERTWIN_GEOMETRY

// --- Products of matrices ---------------------------------------------------

// Overloads for each type, which are preferred to GLM's templates: those add in another order.
namespace detail {

template <int C, int R>
SHADERTWIN_INLINE glm::vec<R, Float> columns_times(const glm::mat<C, R, Float>& m,
                                                   const glm::vec<C, Float>& v) {
  glm::vec<R, Float> sum = m[0] * v[0];
  for (int c = 1; c < C; ++c) sum = sum + m[c] * v[c];
  return sum;
}

template <int C, int R>
SHADERTWIN_INLINE glm::vec<C, Float> row_times(const glm::vec<R, Float>& v, const glm::mat<C, R, Float>& m) {
  glm::vec<C, Float> result;
  for (int c = 0; c < C; ++c) result[c] = dot(v, m[c]);
  return result;
}

template <int N, int C, int R>
SHADERTWIN_INLINE glm::mat<C, R, Float> matrix_times(const glm::mat<N, R, Float>& a,
                                                     const glm::mat<C, N, Float>& b) {
  glm::mat<C, R, Float> result;
  for (int c = 0; c < C; ++c) result[c] = columns_times(a, b[c]);
  return result;
}

}  // namespace detail

#define SHADERTWIN_PRODUCTS(C, R)                                                  \
  SHADERTWIN_INLINE vec##R operator*(const mat##C##x##R& m, const vec##C& v) {     \
    return detail::columns_times(m, v);                                            \
  }                                                                                \
  SHADERTWIN_INLINE vec##C operator*(const vec##R& v, const mat##C##x##R& m) {     \
    return detail::row_times(v, m);                                                \
  }                                                                                \
  SHADERTWIN_INLINE mat2x##R operator*(const mat##C##x##R& a, const mat2x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }                                                                                \
  SHADERTWIN_INLINE mat3x##R operator*(const mat##C##x##R& a, const mat3x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }                                                                                \
  SHADERTWIN_INLINE mat4x##R operator*(const mat##C##x##R& a, const mat4x##C& b) { \
    return detail::matrix_times(a, b);                                             \
  }
SHADERTWIN_PRODUCTS(2, 2)
SHADERTWIN_PRODUCTS(2, 3)
SHADERTWIN_PRODUCTS(2, 4)
SHADERTWIN_PRODUCTS(3, 2)
SHADERTWIN_PRODUCTS(3, 3)
SHADERTWIN_PRODUCTS(3, 4)
SHADERTWIN_PRODUCTS(4, 2)
SHADERTWIN_PRODUCTS(4, 3)
SHADERTWIN_PRODUCTS(4, 4)
#undef SHADERTWIN_PRODUCTS

// Component by component, as everywhere else in GLSL; GLM divides square matrices by the inverse.
namespace detail {
template <int C, int R>
SHADERTWIN_INLINE glm::mat<C, R, Float> component_product(const glm::mat<C, R, Float>& a,
                                                          const glm::mat<C, R, Float>& b) {
  glm::mat<C, R, Float> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] * b[c];
  return result;
}
template <int C, int R>
SHADERTWIN_INLINE glm::mat<C, R, Float> component_quotient(const glm::mat<C, R, Float>& a,
                                                           const glm::mat<C, R, Float>& b) {
  glm::mat<C, R, Float> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] / b[c];
  return result;
}
template <int C, int R>
SHADERTWIN_INLINE glm::mat<R, C, Float> transposed(const glm::mat<C, R, Float>& m) {
  glm::mat<R, C, Float> result;
  for (int c = 0; c < C; ++c) {
    for (int r = 0; r < R; ++r) result[r][c] = m[c][r];
  }
  return result;
}
template <int C, int R>
SHADERTWIN_INLINE glm::mat<C, R, Float> outer(const glm::vec<R, Float>& column,
                                              const glm::vec<C, Float>& row) {
  glm::mat<C, R, Float> result;
  for (int c = 0; c < C; ++c) result[c] = column * row[c];
  return result;
}
}  // namespace detail

#define SHADERTWIN_MATRIX(C, R)                                                                 \
  SHADERTWIN_INLINE mat##C##x##R operator/(const mat##C##x##R& a, const mat##C##x##R& b) {      \
    return detail::component_quotient(a, b);                                                    \
  }                                                                                             \
  SHADERTWIN_INLINE mat##C##x##R matrixCompMult(const mat##C##x##R& a, const mat##C##x##R& b) { \
    return detail::component_product(a, b);                                                     \
  }                                                                                             \
  SHADERTWIN_INLINE mat##R##x##C transpose(const mat##C##x##R& m) {                             \
    return detail::transposed(m);                                                               \
  }                                                                                             \
  SHADERTWIN_INLINE mat##C##x##R outerProduct(const vec##R& column, const vec##C& row) {        \
    return detail::outer(column, row);                                                          \
  }
SHADERTWIN_MATRIX(2, 2)
SHADERTWIN_MATRIX(2, 3)
SHADERTWIN_MATRIX(2, 4)
SHADERTWIN_MATRIX(3, 2)
SHADERTWIN_MATRIX(3, 3)
SHADERTWIN_MATRIX(3, 4)
SHADERTWIN_MATRIX(4, 2)
SHADERTWIN_MATRIX(4, 3)
SHADERTWIN_MATRIX(4, 4)
#undef SHADERTWIN_MATRIX

// --- Determinants and inverses ----------------------------------------------

namespace detail {

// The minor of rows r, s in columns a, b.
template <int N>
SHADERTWIN_INLINE Float minor(const glm::mat<N, N, Float>& m, int a, int b, int r, int s) {
  return m[a][r] * m[b][s] - m[b][r] * m[a][s];
}

// The cofactors by which column 0 of the inverse's adjugate is scaled: also the expansion of the determinant.
SHADERTWIN_INLINE vec4 first_cofactors(const mat4& m) {
  const Float s0 = minor(m, 2, 3, 2, 3);
  const Float s1 = minor(m, 2, 3, 1, 3);
  const Float s2 = minor(m, 2, 3, 1, 2);
  const Float s3 = minor(m, 2, 3, 0, 3);
  const Float s4 = minor(m, 2, 3, 0, 2);
  const Float s5 = minor(m, 2, 3, 0, 1);
  return vec4(m[1][1] * s0 - m[1][2] * s1 + m[1][3] * s2, -(m[1][0] * s0 - m[1][2] * s3 + m[1][3] * s4),
              m[1][0] * s1 - m[1][1] * s3 + m[1][3] * s5, -(m[1][0] * s2 - m[1][1] * s4 + m[1][2] * s5));
}

}  // namespace detail

inline Float determinant(const mat2& m) {
  return m[0][0] * m[1][1] - m[1][0] * m[0][1];
}
inline Float determinant(const mat3& m) {
  const Float f1 = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const Float f2 = m[1][0] * m[2][2] - m[1][2] * m[2][0];
  const Float f3 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
  return m[0][0] * f1 - m[0][1] * f2 + m[0][2] * f3;
}
inline Float determinant(const mat4& m) {
  return dot(m[0], detail::first_cofactors(m));
}

inline mat2 inverse(const mat2& m) {
  const Float det = determinant(m);
  SHADERTWIN_PROBE(det == 0, inverse_of_singular);
  return mat2(m[1][1] / det, -m[0][1] / det, -m[1][0] / det, m[0][0] / det);
}

inline mat3 inverse(const mat3& m) {
  using detail::minor;
  const Float f0 = minor(m, 1, 2, 1, 2);
  const Float f1 = minor(m, 1, 2, 0, 2);
  const Float f2 = minor(m, 1, 2, 0, 1);
  const Float det = m[0][0] * f0 - m[0][1] * f1 + m[0][2] * f2;
  SHADERTWIN_PROBE(det == 0, inverse_of_singular);
  const vec3 c0(f0, -minor(m, 0, 2, 1, 2), minor(m, 0, 1, 1, 2));
  const vec3 c1(-f1, minor(m, 0, 2, 0, 2), -minor(m, 0, 1, 0, 2));
  const vec3 c2(f2, -minor(m, 0, 2, 0, 1), minor(m, 0, 1, 0, 1));
  return mat3(c0 / det, c1 / det, c2 / det);
}

inline mat4 inverse(const mat4& m) {
  using detail::minor;
  const vec4 first = detail::first_cofactors(m);
  const Float det = dot(m[0], first);
  SHADERTWIN_PROBE(det == 0, inverse_of_singular);
  // Cofactors of row `row` of the adjugate, from the minors of columns a and b, expanded along column e.
  const auto row = [&m](int e, int a, int b) {
    const Float s0 = minor(m, a, b, 2, 3);
    const Float s1 = minor(m, a, b, 1, 3);
    const Float s2 = minor(m, a, b, 1, 2);
    const Float s3 = minor(m, a, b, 0, 3);
    const Float s4 = minor(m, a, b, 0, 2);
    const Float s5 = minor(m, a, b, 0, 1);
    return vec4(m[e][1] * s0 - m[e][2] * s1 + m[e][3] * s2, m[e][0] * s0 - m[e][2] * s3 + m[e][3] * s4,
                m[e][0] * s1 - m[e][1] * s3 + m[e][3] * s5, m[e][0] * s2 - m[e][1] * s4 + m[e][2] * s5);
  };
  const vec4 y = row(0, 2, 3);
  const vec4 z = row(0, 1, 3);
  const vec4 w = row(0, 1, 2);
  return mat4(vec4(first.x, -y.x, z.x, -w.x) / det, vec4(first.y, y.y, -z.y, w.y) / det,
              vec4(first.z, -y.z, z.z, -w.z) / det, vec4(first.w, y.w, -z.w, w.w) / det);
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
