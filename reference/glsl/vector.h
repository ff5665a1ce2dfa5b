// Geometry and matrices, in the order in which Mesa adds: dot is x + (y + (z + w)), a matrix times a vector
// adds its columns from the left.
#pragma once

#include "reference/glsl/common.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

// GLM's subtracts a vec4 from zero, which loses the sign of a zero.
SHADERTWIN_INLINE vec4 operator-(vec4 v) {
  return vec4(-v.x, -v.y, -v.z, -v.w);
}

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

// Overloads for each type, which are preferred to GLM's templates: those add in another order. The templates
// below serve packets (packet.h) too.
namespace detail {

template <int C, int R, class T>
SHADERTWIN_INLINE glm::vec<R, T> columns_times(const glm::mat<C, R, T>& m, const glm::vec<C, T>& v) {
  glm::vec<R, T> sum = m[0] * v[0];
  for (int c = 1; c < C; ++c) sum = sum + m[c] * v[c];
  return sum;
}

template <int C, int R, class T>
SHADERTWIN_INLINE glm::vec<C, T> row_times(const glm::vec<R, T>& v, const glm::mat<C, R, T>& m) {
  glm::vec<C, T> result;
  for (int c = 0; c < C; ++c) result[c] = dot(v, m[c]);
  return result;
}

template <int N, int C, int R, class T>
SHADERTWIN_INLINE glm::mat<C, R, T> matrix_times(const glm::mat<N, R, T>& a, const glm::mat<C, N, T>& b) {
  glm::mat<C, R, T> result;
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

// Component by component, as everywhere else in GLSL; GLM divides square matrices by the inverse.
namespace detail {
template <int C, int R, class T>
SHADERTWIN_INLINE glm::mat<C, R, T> component_product(const glm::mat<C, R, T>& a,
                                                      const glm::mat<C, R, T>& b) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] * b[c];
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE glm::mat<C, R, T> component_quotient(const glm::mat<C, R, T>& a,
                                                       const glm::mat<C, R, T>& b) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] / b[c];
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE glm::mat<R, C, T> transposed(const glm::mat<C, R, T>& m) {
  glm::mat<R, C, T> result;
  for (int c = 0; c < C; ++c) {
    for (int r = 0; r < R; ++r) result[r][c] = m[c][r];
  }
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE glm::mat<C, R, T> outer(const glm::vec<R, T>& column, const glm::vec<C, T>& row) {
  glm::mat<C, R, T> result;
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

// --- Determinants and inverses ----------------------------------------------

namespace detail {

// The minor of rows r, s in columns a, b.
template <int N, class T>
SHADERTWIN_INLINE T minor(const glm::mat<N, N, T>& m, int a, int b, int r, int s) {
  return m[a][r] * m[b][s] - m[b][r] * m[a][s];
}

// The cofactors by which column 0 of the inverse's adjugate is scaled: also the expansion of the determinant.
template <class T>
SHADERTWIN_INLINE glm::vec<4, T> first_cofactors(const glm::mat<4, 4, T>& m) {
  const T s0 = minor(m, 2, 3, 2, 3);
  const T s1 = minor(m, 2, 3, 1, 3);
  const T s2 = minor(m, 2, 3, 1, 2);
  const T s3 = minor(m, 2, 3, 0, 3);
  const T s4 = minor(m, 2, 3, 0, 2);
  const T s5 = minor(m, 2, 3, 0, 1);
  return glm::vec<4, T>(
      m[1][1] * s0 - m[1][2] * s1 + m[1][3] * s2, -(m[1][0] * s0 - m[1][2] * s3 + m[1][3] * s4),
      m[1][0] * s1 - m[1][1] * s3 + m[1][3] * s5, -(m[1][0] * s2 - m[1][1] * s4 + m[1][2] * s5));
}

template <class T>
SHADERTWIN_INLINE T determinant_of(const glm::mat<2, 2, T>& m) {
  return m[0][0] * m[1][1] - m[1][0] * m[0][1];
}
template <class T>
SHADERTWIN_INLINE T determinant_of(const glm::mat<3, 3, T>& m) {
  const T f1 = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const T f2 = m[1][0] * m[2][2] - m[1][2] * m[2][0];
  const T f3 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
  return m[0][0] * f1 - m[0][1] * f2 + m[0][2] * f3;
}
template <class T>
SHADERTWIN_INLINE T determinant_of(const glm::mat<4, 4, T>& m) {
  return dot(m[0], first_cofactors(m));
}

template <class T>
inline glm::mat<2, 2, T> inverse_of(const glm::mat<2, 2, T>& m) {
  const T det = determinant_of(m);
  glm::mat<2, 2, T> result;
  result[0] = glm::vec<2, T>(m[1][1] / det, -m[0][1] / det);
  result[1] = glm::vec<2, T>(-m[1][0] / det, m[0][0] / det);
  return result;
}

template <class T>
inline glm::mat<3, 3, T> inverse_of(const glm::mat<3, 3, T>& m) {
  const T f0 = minor(m, 1, 2, 1, 2);
  const T f1 = minor(m, 1, 2, 0, 2);
  const T f2 = minor(m, 1, 2, 0, 1);
  const T det = m[0][0] * f0 - m[0][1] * f1 + m[0][2] * f2;
  glm::mat<3, 3, T> result;
  result[0] = glm::vec<3, T>(f0, -minor(m, 0, 2, 1, 2), minor(m, 0, 1, 1, 2)) / det;
  result[1] = glm::vec<3, T>(-f1, minor(m, 0, 2, 0, 2), -minor(m, 0, 1, 0, 2)) / det;
  result[2] = glm::vec<3, T>(f2, -minor(m, 0, 2, 0, 1), minor(m, 0, 1, 0, 1)) / det;
  return result;
}

template <class T>
inline glm::mat<4, 4, T> inverse_of(const glm::mat<4, 4, T>& m) {
  using V = glm::vec<4, T>;
  const V first = first_cofactors(m);
  const T det = dot(m[0], first);
  // Cofactors of row `row` of the adjugate, from the minors of columns a and b, expanded along column e.
  const auto row = [&m](int e, int a, int b) {
    const T s0 = minor(m, a, b, 2, 3);
    const T s1 = minor(m, a, b, 1, 3);
    const T s2 = minor(m, a, b, 1, 2);
    const T s3 = minor(m, a, b, 0, 3);
    const T s4 = minor(m, a, b, 0, 2);
    const T s5 = minor(m, a, b, 0, 1);
    return V(m[e][1] * s0 - m[e][2] * s1 + m[e][3] * s2, m[e][0] * s0 - m[e][2] * s3 + m[e][3] * s4,
             m[e][0] * s1 - m[e][1] * s3 + m[e][3] * s5, m[e][0] * s2 - m[e][1] * s4 + m[e][2] * s5);
  };
  const V y = row(0, 2, 3);
  const V z = row(0, 1, 3);
  const V w = row(0, 1, 2);
  glm::mat<4, 4, T> result;
  result[0] = V(first.x, -y.x, z.x, -w.x) / det;
  result[1] = V(first.y, y.y, -z.y, w.y) / det;
  result[2] = V(first.z, -y.z, z.z, -w.z) / det;
  result[3] = V(first.w, y.w, -z.w, w.w) / det;
  return result;
}

}  // namespace detail

#define SHADERTWIN_SQUARE(type)                                            \
  inline Float determinant(const type& m) {                                \
    return detail::determinant_of(m);                                      \
  }                                                                        \
  inline type inverse(const type& m) {                                     \
    SHADERTWIN_PROBE(detail::determinant_of(m) == 0, inverse_of_singular); \
    return detail::inverse_of(m);                                          \
  }
SHADERTWIN_SQUARE(mat2)
SHADERTWIN_SQUARE(mat3)
SHADERTWIN_SQUARE(mat4)
#undef SHADERTWIN_SQUARE

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
