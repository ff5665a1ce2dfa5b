// GLSL's types for eight pixels side by side. A scalar that may differ between the pixels is a packet: Float,
// Int, Uint or Bool, with one lane a pixel; vectors, matrices, arrays and structures are made of packets.
// What is the same in all eight stays float, int, uint, bool and uniform::vec3 ..., and becomes a packet by
// itself where it meets one.
//
// Every lane computes what the scalar twin computes, operation by operation: the bits are the same.
#pragma once

#include <concepts>

#include "reference/glsl/glsl.h"

#ifdef SHADERTWIN_DOUBLE
#error "packets are of float32"
#endif

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

// Without AVX the compiler makes two registers of each.
using float8 = float __attribute__((vector_size(32)));
using int8 = int __attribute__((vector_size(32)));
using uint8 = uint __attribute__((vector_size(32)));

template <class Result, class Function>
SHADERTWIN_INLINE Result each_of_eight(const Function& function) {
  Result result{};
  for (int i = 0; i < 8; ++i) result[i] = function(i);
  return result;
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail

// Names that end in two underscores are no shader's.
namespace shadertwin::glsl::packet {

constexpr int lanes = 8;

// What is the same for all lanes.
using glsl::array;
using glsl::Swizzle;
using glsl::swizzle;
namespace uniform {
using glsl::bvec2, glsl::bvec3, glsl::bvec4;
using glsl::ivec2, glsl::ivec3, glsl::ivec4;
using glsl::mat2, glsl::mat2x3, glsl::mat2x4, glsl::mat3, glsl::mat3x2, glsl::mat3x4;
using glsl::mat4, glsl::mat4x2, glsl::mat4x3;
using glsl::uvec2, glsl::uvec3, glsl::uvec4;
using glsl::vec2, glsl::vec3, glsl::vec4;
}  // namespace uniform

// --- Scalars ----------------------------------------------------------------

// True in some lanes; the mask of those that run.
struct Bool {
  using Scalar = bool;
  detail::int8 v;  // all bits of a lane are set, or none

  Bool() = default;
  template <std::same_as<bool> B>
  SHADERTWIN_INLINE Bool(B b) : v(detail::int8{} - static_cast<int>(b)) {}
  SHADERTWIN_INLINE explicit Bool(detail::int8 lanes) : v(lanes) {}

  SHADERTWIN_INLINE friend Bool operator!(Bool a) { return Bool(~a.v); }
  SHADERTWIN_INLINE friend Bool operator&&(Bool a, Bool b) { return Bool(a.v & b.v); }
  SHADERTWIN_INLINE friend Bool operator||(Bool a, Bool b) { return Bool(a.v | b.v); }
  SHADERTWIN_INLINE friend Bool operator|(Bool a, Bool b) { return Bool(a.v | b.v); }
  SHADERTWIN_INLINE friend Bool operator!=(Bool a, Bool b) { return Bool(a.v ^ b.v); }
  SHADERTWIN_INLINE friend Bool operator==(Bool a, Bool b) { return Bool(~(a.v ^ b.v)); }
};

template <class T>
struct VectorOf;
template <>
struct VectorOf<float> {
  using Type = detail::float8;
};
template <>
struct VectorOf<int> {
  using Type = detail::int8;
};
template <>
struct VectorOf<uint> {
  using Type = detail::uint8;
};

template <class T>
struct Packet {
  using Scalar = T;
  using Vector = typename VectorOf<T>::Type;
  Vector v;

  Packet() = default;
  template <std::same_as<T> U>
  SHADERTWIN_INLINE Packet(U x) : v{x, x, x, x, x, x, x, x} {}
  SHADERTWIN_INLINE explicit Packet(Vector x) : v(x) {}

  SHADERTWIN_INLINE friend Packet operator+(Packet a, Packet b) { return Packet(a.v + b.v); }
  SHADERTWIN_INLINE friend Packet operator-(Packet a, Packet b) { return Packet(a.v - b.v); }
  SHADERTWIN_INLINE friend Packet operator*(Packet a, Packet b) { return Packet(a.v * b.v); }
  SHADERTWIN_INLINE friend Packet operator/(Packet a, Packet b) { return Packet(a.v / b.v); }
  SHADERTWIN_INLINE friend Packet operator%(Packet a, Packet b) { return Packet(a.v % b.v); }
  SHADERTWIN_INLINE friend Packet operator&(Packet a, Packet b) { return Packet(a.v & b.v); }
  SHADERTWIN_INLINE friend Packet operator|(Packet a, Packet b) { return Packet(a.v | b.v); }
  SHADERTWIN_INLINE friend Packet operator^(Packet a, Packet b) { return Packet(a.v ^ b.v); }
  SHADERTWIN_INLINE friend Packet operator<<(Packet a, int b) { return Packet(a.v << b); }
  SHADERTWIN_INLINE friend Packet operator>>(Packet a, int b) { return Packet(a.v >> b); }
  template <class U>
  SHADERTWIN_INLINE friend Packet operator<<(Packet a, Packet<U> b) {
    return Packet(a.v << std::bit_cast<Vector>(b.v));
  }
  template <class U>
  SHADERTWIN_INLINE friend Packet operator>>(Packet a, Packet<U> b) {
    return Packet(a.v >> std::bit_cast<Vector>(b.v));
  }
  SHADERTWIN_INLINE friend Packet operator<<(Packet a, uint b) { return a << static_cast<int>(b); }
  SHADERTWIN_INLINE friend Packet operator>>(Packet a, uint b) { return a >> static_cast<int>(b); }
  SHADERTWIN_INLINE friend Packet operator-(Packet a) { return Packet(-a.v); }
  SHADERTWIN_INLINE friend Packet operator+(Packet a) { return a; }
  SHADERTWIN_INLINE friend Packet operator~(Packet a) { return Packet(~a.v); }
  SHADERTWIN_INLINE friend Bool operator<(Packet a, Packet b) { return Bool(a.v < b.v); }
  SHADERTWIN_INLINE friend Bool operator>(Packet a, Packet b) { return Bool(a.v > b.v); }
  SHADERTWIN_INLINE friend Bool operator<=(Packet a, Packet b) { return Bool(a.v <= b.v); }
  SHADERTWIN_INLINE friend Bool operator>=(Packet a, Packet b) { return Bool(a.v >= b.v); }
  SHADERTWIN_INLINE friend Bool operator==(Packet a, Packet b) { return Bool(a.v == b.v); }
  SHADERTWIN_INLINE friend Bool operator!=(Packet a, Packet b) { return Bool(a.v != b.v); }

  SHADERTWIN_INLINE Packet& operator+=(Packet b) { return *this = *this + b; }
  SHADERTWIN_INLINE Packet& operator-=(Packet b) { return *this = *this - b; }
  SHADERTWIN_INLINE Packet& operator*=(Packet b) { return *this = *this * b; }
  SHADERTWIN_INLINE Packet& operator/=(Packet b) { return *this = *this / b; }
  SHADERTWIN_INLINE Packet& operator%=(Packet b) { return *this = *this % b; }
  SHADERTWIN_INLINE Packet& operator&=(Packet b) { return *this = *this & b; }
  SHADERTWIN_INLINE Packet& operator|=(Packet b) { return *this = *this | b; }
  SHADERTWIN_INLINE Packet& operator^=(Packet b) { return *this = *this ^ b; }
  SHADERTWIN_INLINE Packet& operator++() { return *this += Packet(T(1)); }
  SHADERTWIN_INLINE Packet& operator--() { return *this -= Packet(T(1)); }
};

using Float = Packet<float>;
using Int = Packet<int>;
using Uint = Packet<uint>;

using vec2 = glm::vec<2, Float>;
using vec3 = glm::vec<3, Float>;
using vec4 = glm::vec<4, Float>;
using ivec2 = glm::vec<2, Int>;
using ivec3 = glm::vec<3, Int>;
using ivec4 = glm::vec<4, Int>;
using uvec2 = glm::vec<2, Uint>;
using uvec3 = glm::vec<3, Uint>;
using uvec4 = glm::vec<4, Uint>;
using bvec2 = glm::vec<2, Bool>;
using bvec3 = glm::vec<3, Bool>;
using bvec4 = glm::vec<4, Bool>;
using mat2x2 = glm::mat<2, 2, Float>;
using mat2x3 = glm::mat<2, 3, Float>;
using mat2x4 = glm::mat<2, 4, Float>;
using mat3x2 = glm::mat<3, 2, Float>;
using mat3x3 = glm::mat<3, 3, Float>;
using mat3x4 = glm::mat<3, 4, Float>;
using mat4x2 = glm::mat<4, 2, Float>;
using mat4x3 = glm::mat<4, 3, Float>;
using mat4x4 = glm::mat<4, 4, Float>;
using mat2 = mat2x2;
using mat3 = mat3x3;
using mat4 = mat4x4;

// --- Masks ------------------------------------------------------------------

SHADERTWIN_INLINE unsigned bits_of__(Bool mask) {
#ifdef __AVX__
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask.v)));
#else
  unsigned bits = 0;
  for (int i = 0; i < lanes; ++i) bits |= static_cast<unsigned>(mask.v[i] & 1) << i;
  return bits;
#endif
}
SHADERTWIN_INLINE bool any__(Bool mask) {
  return bits_of__(mask) != 0;
}
SHADERTWIN_INLINE bool none__(Bool mask) {
  return bits_of__(mask) == 0;
}
// The lanes of the first mask leave it and all the others.
template <class... Masks>
SHADERTWIN_INLINE void mask_out__(Bool& mask, Masks&... others) {
  ((others = others && !mask), ...);
  mask = Bool(false);
}
// Only lanes of `alive` stay.
template <class... Masks>
SHADERTWIN_INLINE void keep__(Bool alive, Masks&... masks) {
  ((masks = masks && alive), ...);
}

// --- Lanes ------------------------------------------------------------------

// The type of one lane of a value, and the value that has such lanes.
template <class T>
struct LaneOf {
  using Type = T;
};
template <>
struct LaneOf<Bool> {
  using Type = bool;
};
template <class T>
struct LaneOf<Packet<T>> {
  using Type = T;
};
template <int N, class T>
struct LaneOf<glm::vec<N, T>> {
  using Type = glm::vec<N, typename LaneOf<T>::Type>;
};
template <int C, int R, class T>
struct LaneOf<glm::mat<C, R, T>> {
  using Type = glm::mat<C, R, typename LaneOf<T>::Type>;
};
template <class T>
using Lane = typename LaneOf<T>::Type;

template <class T>
struct VaryingOf {
  using Type = T;
};
template <>
struct VaryingOf<bool> {
  using Type = Bool;
};
template <>
struct VaryingOf<float> {
  using Type = Float;
};
template <>
struct VaryingOf<int> {
  using Type = Int;
};
template <>
struct VaryingOf<uint> {
  using Type = Uint;
};
template <int N, class T>
struct VaryingOf<glm::vec<N, T>> {
  using Type = glm::vec<N, typename VaryingOf<T>::Type>;
};
template <int C, int R, class T>
struct VaryingOf<glm::mat<C, R, T>> {
  using Type = glm::mat<C, R, typename VaryingOf<T>::Type>;
};
template <class T, int N>
struct VaryingOf<array<T, N>> {
  using Type = array<typename VaryingOf<T>::Type, N>;
};
template <class T>
using Varying = typename VaryingOf<T>::Type;

template <class T>
SHADERTWIN_INLINE Lane<T> lane__(const T& value, int i) {
  if constexpr (std::is_same_v<Lane<T>, T>) {
    return value;
  } else if constexpr (detail::Shape<T>::matrix || detail::Shape<T>::rows > 1) {
    Lane<T> result;
    for (int c = 0; c < value.length(); ++c) result[c] = lane__(value[c], i);
    return result;
  } else if constexpr (std::is_same_v<T, Bool>) {
    return value.v[i] != 0;
  } else {
    return value.v[i];
  }
}
template <class T>
SHADERTWIN_INLINE void set_lane__(T& value, int i, const Lane<T>& lane) {
  if constexpr (detail::Shape<T>::matrix || detail::Shape<T>::rows > 1) {
    for (int c = 0; c < value.length(); ++c) set_lane__(value[c], i, lane[c]);
  } else if constexpr (std::is_same_v<T, Bool>) {
    value.v[i] = -static_cast<int>(lane);
  } else {
    value.v[i] = lane;
  }
}

// f(i) in each lane i of `mask`, zero in the others.
template <class F>
SHADERTWIN_INLINE auto each_lane__(Bool mask, const F& f) {
  Varying<decltype(f(0))> result{};
  for (unsigned left = bits_of__(mask); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    set_lane__(result, i, f(i));
  }
  return result;
}
// The same in all lanes.
template <class F>
SHADERTWIN_INLINE auto every_lane__(const F& f) {
  return each_lane__(Bool(true), f);
}

// --- Choice and masked assignment -------------------------------------------

template <class T>
SHADERTWIN_INLINE Packet<T> choice__(Bool c, Packet<T> a, Packet<T> b) {
#ifdef __AVX__
  return Packet<T>(std::bit_cast<typename Packet<T>::Vector>(
      _mm256_blendv_ps(std::bit_cast<__m256>(b.v), std::bit_cast<__m256>(a.v), std::bit_cast<__m256>(c.v))));
#else
  return Packet<T>(std::bit_cast<typename Packet<T>::Vector>((std::bit_cast<detail::int8>(a.v) & c.v) |
                                                             (std::bit_cast<detail::int8>(b.v) & ~c.v)));
#endif
}
// Not templates, so that a uniform scalar becomes a packet.
SHADERTWIN_INLINE Float select__(Bool c, Float a, Float b) {
  return choice__(c, a, b);
}
SHADERTWIN_INLINE Int select__(Bool c, Int a, Int b) {
  return choice__(c, a, b);
}
SHADERTWIN_INLINE Uint select__(Bool c, Uint a, Uint b) {
  return choice__(c, a, b);
}
SHADERTWIN_INLINE Bool select__(Bool c, Bool a, Bool b) {
  return Bool((c.v & a.v) | (~c.v & b.v));
}
template <int N, class T>
SHADERTWIN_INLINE glm::vec<N, T> select__(Bool c, const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
  glm::vec<N, T> result;
  for (int i = 0; i < N; ++i) result[i] = select__(c, a[i], b[i]);
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE glm::mat<C, R, T> select__(Bool c, const glm::mat<C, R, T>& a, const glm::mat<C, R, T>& b) {
  glm::mat<C, R, T> result;
  for (int i = 0; i < C; ++i) result[i] = select__(c, a[i], b[i]);
  return result;
}

// `to = from` in the lanes of the mask. A structure has a set__ of its own.
template <class T>
SHADERTWIN_INLINE void set__(Bool mask, T& to, const std::type_identity_t<T>& from) {
  to = select__(mask, from, to);
}
template <class T, int N>
SHADERTWIN_INLINE void set__(Bool mask, array<T, N>& to, const std::type_identity_t<array<T, N>>& from) {
  for (int i = 0; i < N; ++i) set__(mask, to.elements[i], from.elements[i]);
}
template <class Vector, int... I>
SHADERTWIN_INLINE void set__(Bool mask, Swizzle<Vector, I...> to,
                             const typename Swizzle<Vector, I...>::Value& from) {
  to = select__(mask, from, typename Swizzle<Vector, I...>::Value(to));
}

// --- Equality of what is no scalar ------------------------------------------

SHADERTWIN_INLINE Bool same__(Bool a, Bool b) {
  return a == b;
}
template <class T>
SHADERTWIN_INLINE Bool same__(Packet<T> a, Packet<T> b) {
  return a == b;
}
template <int N, class T>
SHADERTWIN_INLINE Bool same__(const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
  Bool result = true;
  for (int i = 0; i < N; ++i) result = result && a[i] == b[i];
  return result;
}
template <int C, int R, class T>
SHADERTWIN_INLINE Bool same__(const glm::mat<C, R, T>& a, const glm::mat<C, R, T>& b) {
  Bool result = true;
  for (int i = 0; i < C; ++i) result = result && same__(a[i], b[i]);
  return result;
}
template <class T, int N>
Bool same__(const array<T, N>& a, const array<T, N>& b) {
  Bool result = true;
  for (int i = 0; i < N; ++i) result = result && same__(a.elements[i], b.elements[i]);
  return result;
}

}  // namespace shadertwin::glsl::packet
