// GLSL's types: scalars, GLM's vectors and matrices, arrays by value, swizzled writes and constructors.
//
// SHADERTWIN_DOUBLE widens Float and every vecN and matN to double; SHADERTWIN_SHADOW makes each number a
// float and a double side by side (shadow.h).
#pragma once

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE  // v.xyz(): member functions, since they give plain vectors
#endif
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/mat2x3.hpp>
#include <glm/mat2x4.hpp>
#include <glm/mat3x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat3x4.hpp>
#include <glm/mat4x2.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>
#include <utility>

#include "reference/glsl/check.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#ifdef __has_feature
#if __has_feature(memory_sanitizer)
#define SHADERTWIN_MEMORY_SANITIZER
#endif
#endif

// Floats and doubles live in inline namespaces of their own, so that one program can hold both.
#if defined(SHADERTWIN_DOUBLE)
#define SHADERTWIN_PRECISION as_double
#elif defined(SHADERTWIN_SHADOW)
#define SHADERTWIN_PRECISION as_shadow
#else
#define SHADERTWIN_PRECISION as_float
#endif

// Small enough that a call would cost more than the work.
//
// Functions of templates are `std::same_as<T> auto` instead of T where they take long to compile: to deduce
// it, GCC makes them while it compiles the headers in advance, and not at the end of every twin.
#define SHADERTWIN_INLINE [[gnu::always_inline]] inline
// Long and rare. GCC 12 also stumbles (an internal error of its SLP pass) over atan2 inlined with constant
// arguments.
#define SHADERTWIN_OUTLINE [[gnu::noinline]]

#ifdef SHADERTWIN_SHADOW
#include "reference/glsl/shadow.h"
#endif

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

#if defined(SHADERTWIN_DOUBLE)
using Float = double;
#elif defined(SHADERTWIN_SHADOW)
using Float = Shadow;
#else
using Float = float;
#endif
using uint = std::uint32_t;

using vec2 = glm::vec<2, Float>;
using vec3 = glm::vec<3, Float>;
using vec4 = glm::vec<4, Float>;
using ivec2 = glm::vec<2, int>;
using ivec3 = glm::vec<3, int>;
using ivec4 = glm::vec<4, int>;
using uvec2 = glm::vec<2, uint>;
using uvec3 = glm::vec<3, uint>;
using uvec4 = glm::vec<4, uint>;
using bvec2 = glm::vec<2, bool>;
using bvec3 = glm::vec<3, bool>;
using bvec4 = glm::vec<4, bool>;

// matCxR: C columns of R rows, as in GLSL.
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

// Index into `size` elements; what lies outside is clamped, as WebGL has it.
SHADERTWIN_INLINE constexpr int clamp_index(int index, int size) {
  SHADERTWIN_PROBE(index < 0 || index >= size, index_out_of_bounds);
  return index < 0 ? 0 : index < size ? index : size - 1;
}
SHADERTWIN_INLINE constexpr int clamp_index(uint index, int size) {
  SHADERTWIN_PROBE(index >= static_cast<uint>(size), index_out_of_bounds);
  return index < static_cast<uint>(size) ? static_cast<int>(index) : size - 1;
}

// T[N], passed and compared by value.
template <class T, int N>
struct array {
  T elements[N];

  SHADERTWIN_INLINE constexpr T& operator[](int index) { return elements[clamp_index(index, N)]; }
  SHADERTWIN_INLINE constexpr const T& operator[](int index) const { return elements[clamp_index(index, N)]; }
  SHADERTWIN_INLINE constexpr T& operator[](uint index) { return elements[clamp_index(index, N)]; }
  SHADERTWIN_INLINE constexpr const T& operator[](uint index) const {
    return elements[clamp_index(index, N)];
  }
  constexpr int length() const { return N; }
  bool operator==(const array&) const = default;
};

// v[i] and m[i] for an index that is no constant: component or column.
template <int N, class T, std::integral Index>
SHADERTWIN_INLINE T& at(glm::vec<N, T>& v, Index index) {
  return v[clamp_index(index, N)];
}
template <int N, class T, std::integral Index>
SHADERTWIN_INLINE T at(const glm::vec<N, T>& v, Index index) {
  return v[clamp_index(index, N)];
}
template <int C, int R, class T, std::integral Index>
SHADERTWIN_INLINE glm::vec<R, T>& at(glm::mat<C, R, T>& m, Index index) {
  return m[clamp_index(index, C)];
}
template <int C, int R, class T, std::integral Index>
SHADERTWIN_INLINE glm::vec<R, T> at(const glm::mat<C, R, T>& m, Index index) {
  return m[clamp_index(index, C)];
}

// The components I... of a vector as something to assign to.
template <class Vector, int... I>
class Swizzle {
 public:
  using Component = typename Vector::value_type;
  using Value = glm::vec<sizeof...(I), Component>;

  explicit Swizzle(Vector& vector) : vector_(vector) {}

  SHADERTWIN_INLINE operator Value() const { return Value(vector_[I]...); }
  // By value: what is assigned may be a swizzle of the same vector.
  SHADERTWIN_INLINE Value operator=(Value value) {
    int from = 0;
    ((vector_[I] = value[from++]), ...);
    return value;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator+=(const T& right) {
    return *this = Value(*this) + right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator-=(const T& right) {
    return *this = Value(*this) - right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator*=(const T& right) {
    return *this = Value(*this) * right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator/=(const T& right) {
    return *this = Value(*this) / right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator&=(const T& right) {
    return *this = Value(*this) & right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator|=(const T& right) {
    return *this = Value(*this) | right;
  }
  template <class T>
  SHADERTWIN_INLINE Value operator^=(const T& right) {
    return *this = Value(*this) ^ right;
  }

 private:
  Vector& vector_;
};

// v.xz = value is written swizzle<0, 2>(v) = value.
template <int... I, int N, class T>
SHADERTWIN_INLINE Swizzle<glm::vec<N, T>, I...> swizzle(glm::vec<N, T>& v) {
  return Swizzle<glm::vec<N, T>, I...>(v);
}

namespace detail {

#if defined(__SSE2__)
// The register that x is in; what stands beside x is not defined, since _mm_set_ss would spend an instruction
// on it.
SHADERTWIN_INLINE __m128 lane(float x) {
#ifdef SHADERTWIN_MEMORY_SANITIZER
  return _mm_set1_ps(x);
#elif defined(__clang__)
  __m128 vector = _mm_undefined_ps();
  vector[0] = x;
  return vector;
#else
  __m128 vector;
  asm("" : "=x"(vector) : "0"(x));
  return vector;
#endif
}
#endif

// The nearest that the target holds; 0 for a NaN.
template <class F>
SHADERTWIN_INLINE int float_to_int(F x) {
  [[maybe_unused]] constexpr F below = sizeof(F) == 4 ? -2147483904.0 : -2147483649.0;
  SHADERTWIN_PROBE(!(x > below && x < F(2147483648.0)), conversion_out_of_range);
  return x != x                  ? 0
         : x <= F(-2147483648.0) ? INT32_MIN
         : x >= F(2147483648.0)  ? INT32_MAX
                                 : static_cast<int>(x);
}
template <class F>
SHADERTWIN_INLINE uint float_to_uint(F x) {
  SHADERTWIN_PROBE(!(x > F(-1) && x < F(4294967296.0)), conversion_out_of_range);
  return !(x > F(0)) ? 0U : x >= F(4294967296.0) ? UINT32_MAX : static_cast<uint>(x);
}
#ifdef SHADERTWIN_SHADOW
SHADERTWIN_INLINE int float_to_int(const Shadow& x) {
  const int of_float = float_to_int(x.value);
  const int of_double = float_to_int(x.exact);
  return of_float == of_double ? of_float : parted__(of_float, of_double, x);
}
SHADERTWIN_INLINE uint float_to_uint(const Shadow& x) {
  const uint of_float = float_to_uint(x.value);
  const uint of_double = float_to_uint(x.exact);
  return of_float == of_double ? of_float : parted__(of_float, of_double, x);
}
#endif

template <class T>
constexpr bool is_real = std::is_floating_point_v<T> || std::is_same_v<T, Float>;

template <class To, class From>
SHADERTWIN_INLINE To convert(From x) {
  if constexpr (std::is_same_v<To, From>) {
    return x;
  } else if constexpr (std::is_same_v<To, bool>) {
    return x != From(0);
  } else if constexpr (is_real<From> && std::is_same_v<To, int>) {
    return float_to_int(x);
  } else if constexpr (is_real<From> && std::is_same_v<To, uint>) {
    return float_to_uint(x);
  } else {
    return static_cast<To>(x);
  }
}

// What a constructor's arguments are made of.
template <class T>
struct Shape {
  using Scalar = T;
  static constexpr int columns = 1;
  static constexpr int rows = 1;
  static constexpr bool matrix = false;
};
template <int N, class T>
struct Shape<glm::vec<N, T>> {
  using Scalar = T;
  static constexpr int columns = 1;
  static constexpr int rows = N;
  static constexpr bool matrix = false;
};
template <int C, int R, class T>
struct Shape<glm::mat<C, R, T>> {
  using Scalar = T;
  static constexpr int columns = C;
  static constexpr int rows = R;
  static constexpr bool matrix = true;
};

template <int I, class T>
SHADERTWIN_INLINE auto component(const T& x) {
  if constexpr (Shape<T>::matrix) {
    return x[I / Shape<T>::rows][I % Shape<T>::rows];
  } else if constexpr (Shape<T>::rows > 1) {
    return x[I];
  } else {
    return x;
  }
}

// Component I of the arguments laid end to end.
template <class Scalar, int I, class First, class... Rest>
SHADERTWIN_INLINE Scalar flattened(const First& first, const Rest&... rest) {
  constexpr int size = Shape<First>::columns * Shape<First>::rows;
  if constexpr (I < size) {
    return convert<Scalar>(component<I>(first));
  } else {
    return flattened<Scalar, I - size>(rest...);
  }
}

template <class T, std::size_t... I, class... Arguments>
SHADERTWIN_INLINE T make_of(std::index_sequence<I...> /*components*/, const Arguments&... arguments) {
  return T(flattened<typename Shape<T>::Scalar, static_cast<int>(I)>(arguments...)...);
}

template <class To, int C, int R, class From>
SHADERTWIN_INLINE To matrix_of_matrix(const glm::mat<C, R, From>& m) {
  To result(typename Shape<To>::Scalar(1));
  for (int c = 0; c < C && c < Shape<To>::columns; ++c) {
    for (int r = 0; r < R && r < Shape<To>::rows; ++r) result[c][r] = m[c][r];
  }
  return result;
}

}  // namespace detail

// GLSL's constructor T(arguments...) with all its rules: conversion of every component, one scalar for all
// components or for a diagonal, a matrix out of another, surplus components dropped.
template <class T, class First, class... Rest>
SHADERTWIN_INLINE T make(const First& first, const Rest&... rest) {
  using To = detail::Shape<T>;
  using From = detail::Shape<First>;
  if constexpr (To::rows * To::columns == 1) {
    return detail::convert<T>(detail::component<0>(first));
  } else if constexpr (sizeof...(Rest) == 0 && From::matrix && To::matrix) {
    return detail::matrix_of_matrix<T>(first);
  } else if constexpr (sizeof...(Rest) == 0 && From::rows * From::columns == 1) {
    return T(detail::convert<typename To::Scalar>(first));
  } else {
    return detail::make_of<T>(std::make_index_sequence<To::rows * To::columns>(), first, rest...);
  }
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
