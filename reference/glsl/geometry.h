// Geometry of vectors of any number type, in the order in which Mesa adds: dot is x + (y + (z + w)).
#pragma once

#include "reference/glsl/common.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

template <class F>
SHADERTWIN_INLINE std::same_as<F> auto dot_of(F a, F b) {
  return a * b;
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto dot_of(const glm::vec<2, F>& a, const glm::vec<2, F>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto dot_of(const glm::vec<3, F>& a, const glm::vec<3, F>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto dot_of(const glm::vec<4, F>& a, const glm::vec<4, F>& b) {
  return a.x * b.x + (a.y * b.y + (a.z * b.z + a.w * b.w));
}
template <class F>
SHADERTWIN_INLINE std::same_as<glm::vec<3, F>> auto cross_of(const glm::vec<3, F>& a,
                                                             const glm::vec<3, F>& b) {
  return glm::vec<3, F>(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// Of a number too, Mesa takes the root of the square: what is below 2^-63 or above 2^64 has no length.
template <class V>
SHADERTWIN_INLINE auto length_of(const V& v) {
  return root(dot_of(v, v));
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto distance_of(F a, F b) {
  return magnitude_of(a - b);
}
template <int N, class F>
SHADERTWIN_INLINE std::same_as<F> auto distance_of(const glm::vec<N, F>& a, const glm::vec<N, F>& b) {
  return length_of(a - b);
}
template <class F>
SHADERTWIN_INLINE F normalize_of(F x) {
  SHADERTWIN_PROBE(x == 0.0F, normalize_zero);
  return sign_of(x);
}
template <int N, class F>
SHADERTWIN_INLINE glm::vec<N, F> normalize_of(const glm::vec<N, F>& v) {
  const F square = dot_of(v, v);
  SHADERTWIN_PROBE(square == 0.0F, normalize_zero);
  return v * (1.0F / root(square));
}
template <class F>
SHADERTWIN_INLINE F faceforward_of(F n, F incident, F reference) {
  return select__(reference * incident < 0.0F, n, -n);
}
// By components: GLM subtracts a vec4 from zero, which loses the sign of a zero.
template <int N, class F>
SHADERTWIN_INLINE glm::vec<N, F> faceforward_of(const glm::vec<N, F>& n, const glm::vec<N, F>& incident,
                                                const glm::vec<N, F>& reference) {
  const Mask<F> is_forward = dot_of(reference, incident) < 0.0F;
  glm::vec<N, F> result;
  for (int i = 0; i < N; ++i) result[i] = select__(is_forward, n[i], -n[i]);
  return result;
}
template <class F>
SHADERTWIN_INLINE std::same_as<F> auto reflect_of(F incident, F n) {
  return incident - 2.0F * (n * incident * n);
}
template <int N, class F>
SHADERTWIN_INLINE std::same_as<glm::vec<N, F>> auto reflect_of(const glm::vec<N, F>& incident,
                                                               const glm::vec<N, F>& n) {
  return incident - (2.0F * dot_of(n, incident)) * n;
}
template <class V, class F>
SHADERTWIN_INLINE std::same_as<V> auto refract_of(const V& incident, const V& n, F eta) {
  const F d = dot_of(n, incident);
  const F k = 1.0F - eta * (eta * (1.0F - d * d));
  return select__(k < 0.0F, V(constant<F>(0)), eta * incident - (eta * d + root(k)) * n);
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
