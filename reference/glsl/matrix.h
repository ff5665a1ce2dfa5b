// Matrices of any number type, in the order in which Mesa adds: a matrix times a vector adds its columns from
// the left.
#pragma once

#include "reference/glsl/geometry.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// --- Products ---------------------------------------------------------------

template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::vec<R, T>> auto columns_times(const glm::mat<C, R, T>& m,
                                                                  const glm::vec<C, T>& v) {
  glm::vec<R, T> sum = m[0] * v[0];
  for (int c = 1; c < C; ++c) sum = sum + m[c] * v[c];
  return sum;
}

template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::vec<C, T>> auto row_times(const glm::vec<R, T>& v,
                                                              const glm::mat<C, R, T>& m) {
  glm::vec<C, T> result;
  for (int c = 0; c < C; ++c) result[c] = dot_of(v, m[c]);
  return result;
}

template <int N, int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::mat<C, R, T>> auto matrix_times(const glm::mat<N, R, T>& a,
                                                                    const glm::mat<C, N, T>& b) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = columns_times(a, b[c]);
  return result;
}

// --- Component by component -------------------------------------------------

// As everywhere else in GLSL; GLM divides square matrices by the inverse.
template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::mat<C, R, T>> auto matrixCompMult_of(const glm::mat<C, R, T>& a,
                                                                         const glm::mat<C, R, T>& b) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] * b[c];
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::mat<C, R, T>> auto component_quotient(const glm::mat<C, R, T>& a,
                                                                          const glm::mat<C, R, T>& b) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = a[c] / b[c];
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::mat<R, C, T>> auto transpose_of(const glm::mat<C, R, T>& m) {
  glm::mat<R, C, T> result;
  for (int c = 0; c < C; ++c) {
    for (int r = 0; r < R; ++r) result[r][c] = m[c][r];
  }
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE std::same_as<glm::mat<C, R, T>> auto outerProduct_of(const glm::vec<R, T>& column,
                                                                       const glm::vec<C, T>& row) {
  glm::mat<C, R, T> result;
  for (int c = 0; c < C; ++c) result[c] = column * row[c];
  return result;
}

// --- Determinants and inverses ----------------------------------------------

// The minor of rows r, s in columns a, b.
template <int N, class T>
SHADERTWIN_INLINE std::same_as<T> auto minor(const glm::mat<N, N, T>& m, int a, int b, int r, int s) {
  return m[a][r] * m[b][s] - m[b][r] * m[a][s];
}

// The cofactors by which column 0 of the inverse's adjugate is scaled: also the expansion of the determinant.
template <class T>
SHADERTWIN_INLINE std::same_as<glm::vec<4, T>> auto first_cofactors(const glm::mat<4, 4, T>& m) {
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
SHADERTWIN_INLINE std::same_as<T> auto determinant_of(const glm::mat<2, 2, T>& m) {
  return m[0][0] * m[1][1] - m[1][0] * m[0][1];
}
template <class T>
SHADERTWIN_INLINE std::same_as<T> auto determinant_of(const glm::mat<3, 3, T>& m) {
  const T f1 = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const T f2 = m[1][0] * m[2][2] - m[1][2] * m[2][0];
  const T f3 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
  return m[0][0] * f1 - m[0][1] * f2 + m[0][2] * f3;
}
template <class T>
SHADERTWIN_INLINE std::same_as<T> auto determinant_of(const glm::mat<4, 4, T>& m) {
  return dot_of(m[0], first_cofactors(m));
}

template <class T>
inline std::same_as<glm::mat<2, 2, T>> auto inverse_unchecked(const glm::mat<2, 2, T>& m) {
  const T det = determinant_of(m);
  glm::mat<2, 2, T> result;
  result[0] = glm::vec<2, T>(m[1][1] / det, -m[0][1] / det);
  result[1] = glm::vec<2, T>(-m[1][0] / det, m[0][0] / det);
  return result;
}

template <class T>
inline std::same_as<glm::mat<3, 3, T>> auto inverse_unchecked(const glm::mat<3, 3, T>& m) {
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
inline std::same_as<glm::mat<4, 4, T>> auto inverse_unchecked(const glm::mat<4, 4, T>& m) {
  using V = glm::vec<4, T>;
  const V first = first_cofactors(m);
  const T det = dot_of(m[0], first);
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

template <int N, class T>
inline std::same_as<glm::mat<N, N, T>> auto inverse_of(const glm::mat<N, N, T>& m) {
  SHADERTWIN_PROBE(determinant_of(m) == 0.0F, inverse_of_singular);
  return inverse_unchecked(m);
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
