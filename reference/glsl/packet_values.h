// GLSL's constructors of packets, and elements at an index that each pixel chooses for itself.
#pragma once

#include "reference/glsl/packet.h"

namespace shadertwin::glsl::packet {

// --- Conversions and constructors -------------------------------------------

namespace implementation {

template <class To, class From>
SHADERTWIN_INLINE To convert(const From& x) {
  using Scalar = typename To::Scalar;
  if constexpr (std::is_same_v<To, From>) {
    return x;
  } else if constexpr (std::is_arithmetic_v<From>) {
    return To(detail::convert<Scalar>(x));
  } else if constexpr (std::is_same_v<To, Bool>) {
    return x != From(typename From::Scalar(0));
  } else if constexpr (std::is_same_v<From, Bool>) {
    return select__(x, To(Scalar(1)), To(Scalar(0)));
  } else if constexpr (std::is_same_v<From, Float>) {
#ifdef __AVX__
    // The instruction gives 0x80000000 for what is too large, and for a NaN.
    if constexpr (std::is_same_v<To, Int>)
      return Int((reinterpret_cast<detail::int8>(_mm256_cvttps_epi32(x.v)) ^ (x.v >= 2147483648.0F)) &
                 (x.v == x.v));
#endif
#if defined(__AVX512VL__) && defined(__AVX512DQ__)
    if constexpr (std::is_same_v<To, Uint>)
      return Uint(reinterpret_cast<detail::uint8>(_mm256_cvttps_epu32(_mm256_max_ps(x.v, detail::float8{}))));
#endif
    return every_lane__([&](int i) { return detail::convert<Scalar>(x.v[i]); });
  } else if constexpr (std::is_same_v<To, Float>) {
    return Float(__builtin_convertvector(x.v, detail::float8));
  } else {
    return To(std::bit_cast<typename To::Vector>(x.v));
  }
}

template <class Scalar, int I, class First, class... Rest>
SHADERTWIN_INLINE Scalar flattened(const First& first, const Rest&... rest) {
  constexpr int size = detail::Shape<First>::columns * detail::Shape<First>::rows;
  if constexpr (I < size) {
    return convert<Scalar>(detail::component<I>(first));
  } else {
    return flattened<Scalar, I - size>(rest...);
  }
}

template <class T, std::size_t... I, class... Arguments>
SHADERTWIN_INLINE T make_of(std::index_sequence<I...> /*components*/, const Arguments&... arguments) {
  using Scalar = typename detail::Shape<T>::Scalar;
  T result;
  if constexpr (detail::Shape<T>::matrix) {
    constexpr int rows = detail::Shape<T>::rows;
    ((result[I / rows][I % rows] = flattened<Scalar, static_cast<int>(I)>(arguments...)), ...);
  } else {
    ((result[I] = flattened<Scalar, static_cast<int>(I)>(arguments...)), ...);
  }
  return result;
}

template <class To, class From>
SHADERTWIN_INLINE To matrix_of(const From& from) {
  using Scalar = typename detail::Shape<To>::Scalar;
  constexpr bool is_matrix = detail::Shape<From>::matrix;
  To result;
  for (int c = 0; c < detail::Shape<To>::columns; ++c) {
    for (int r = 0; r < detail::Shape<To>::rows; ++r) {
      result[c][r] = c == r ? Scalar(1.0F) : Scalar(0.0F);
      if constexpr (is_matrix) {
        if (c < detail::Shape<From>::columns && r < detail::Shape<From>::rows)
          result[c][r] = convert<Scalar>(from[c][r]);
      } else if (c == r) {
        result[c][r] = convert<Scalar>(from);
      }
    }
  }
  return result;
}

}  // namespace implementation

template <class T>
constexpr bool is_varying = !std::is_same_v<Lane<T>, T>;

// GLSL's constructor, as glsl::make.
template <class T, class First, class... Rest>
SHADERTWIN_INLINE T make(const First& first, const Rest&... rest) {
  if constexpr (!is_varying<T>) {
    return glsl::make<T>(first, rest...);
  } else {
    using To = detail::Shape<T>;
    using From = detail::Shape<First>;
    constexpr bool is_one = sizeof...(Rest) == 0;
    if constexpr (To::rows * To::columns == 1) {
      return implementation::convert<T>(detail::component<0>(first));
    } else if constexpr (is_one && To::matrix && (From::matrix || From::rows * From::columns == 1)) {
      return implementation::matrix_of<T>(first);
    } else if constexpr (is_one && From::rows * From::columns == 1) {
      return T(implementation::convert<typename To::Scalar>(first));
    } else {
      return implementation::make_of<T>(std::make_index_sequence<To::rows * To::columns>(), first, rest...);
    }
  }
}

// A uniform array as one that may vary.
template <class T>
SHADERTWIN_INLINE Varying<T> spread__(const T& value) {
  if constexpr (requires { value.elements; }) {
    Varying<T> result;
    for (int i = 0; i < value.length(); ++i) result.elements[i] = spread__(value.elements[i]);
    return result;
  } else if constexpr (detail::Shape<T>::matrix || detail::Shape<T>::rows > 1) {
    return make<Varying<T>>(value);
  } else {
    return Varying<T>(value);
  }
}

// --- Elements at an index that varies ---------------------------------------

SHADERTWIN_INLINE Int clamped__(Int index, int size) {
  const Int last(size - 1);
  const Int lower = select__(index < last, index, last);
  return select__(lower > Int(0), lower, Int(0));
}
SHADERTWIN_INLINE Int clamped__(Uint index, int size) {
  const Uint last(static_cast<uint>(size - 1));
  return Int(std::bit_cast<detail::int8>(select__(index < last, index, last).v));
}

namespace implementation {

using Word [[gnu::may_alias]] = int;
using Words [[gnu::may_alias]] = detail::int8;

// 32-bit words at base + offset[i].
SHADERTWIN_INLINE detail::int8 words_at(const void* base, detail::int8 offset) {
#ifdef __AVX2__
  return reinterpret_cast<detail::int8>(
      _mm256_i32gather_epi32(static_cast<const int*>(base), reinterpret_cast<__m256i>(offset), 4));
#else
  return detail::each_of_eight<detail::int8>(
      [&](int i) { return static_cast<const Word*>(base)[offset[i]]; });
#endif
}

constexpr detail::int8 lane_numbers = {0, 1, 2, 3, 4, 5, 6, 7};

// Element index[i] for lane i. Everything is made of 32-bit words: a packet of eight, a uniform scalar of
// one.
template <class T, class Result>
SHADERTWIN_INLINE void gather(const T* elements, Int index, Result& result) {
  constexpr int words = sizeof(T) / sizeof(Word);
  constexpr bool of_packets = sizeof(T) == sizeof(Result);
  const detail::int8 offset = of_packets ? index.v * words + lane_numbers : index.v * words;
  constexpr int step = of_packets ? lanes : 1;
  for (std::size_t i = 0; i < sizeof(Result) / sizeof(Words); ++i)
    reinterpret_cast<Words*>(&result)[i] =
        words_at(reinterpret_cast<const Word*>(elements) + i * step, offset);
}

}  // namespace implementation

template <class T, int N, class Index>
SHADERTWIN_INLINE Varying<T> at(const array<T, N>& a, Packet<Index> index) {
  Varying<T> result;
  implementation::gather(a.elements, clamped__(index, N), result);
  return result;
}
template <int N, class T, class Index>
SHADERTWIN_INLINE Varying<T> at(const glm::vec<N, T>& v, Packet<Index> index) {
  const Int i = clamped__(index, N);
  Varying<T> result(v[0]);
  for (int c = 1; c < N; ++c) result = select__(i == Int(c), Varying<T>(v[c]), result);
  return result;
}
template <int C, int R, class T, class Index>
SHADERTWIN_INLINE glm::vec<R, Varying<T>> at(const glm::mat<C, R, T>& m, Packet<Index> index) {
  const Int i = clamped__(index, C);
  glm::vec<R, Varying<T>> result(m[0]);
  for (int c = 1; c < C; ++c) result = select__(i == Int(c), glm::vec<R, Varying<T>>(m[c]), result);
  return result;
}
// An index that does not vary.
using glsl::at;

// Writes `value` to element index[i] in each lane i of the mask.
template <class T, int N, class Index>
void put__(Bool mask, array<T, N>& a, Packet<Index> index, const std::type_identity_t<T>& value) {
  const Int element = clamped__(index, N);
  for (unsigned left = bits_of__(mask); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    implementation::Word* to = reinterpret_cast<implementation::Word*>(&a.elements[element.v[i]]);
    const implementation::Word* from = reinterpret_cast<const implementation::Word*>(&value);
    for (std::size_t word = i; word < sizeof(T) / sizeof(int); word += lanes) to[word] = from[word];
  }
}
template <int N, class T, class Index>
SHADERTWIN_INLINE void put__(Bool mask, glm::vec<N, T>& v, Packet<Index> index,
                             const std::type_identity_t<T>& value) {
  const Int i = clamped__(index, N);
  for (int c = 0; c < N; ++c) set__(mask && i == Int(c), v[c], value);
}
template <int C, int R, class T, class Index>
SHADERTWIN_INLINE void put__(Bool mask, glm::mat<C, R, T>& m, Packet<Index> index,
                             const std::type_identity_t<glm::vec<R, T>>& value) {
  const Int i = clamped__(index, C);
  for (int c = 0; c < C; ++c) set__(mask && i == Int(c), m[c], value);
}

}  // namespace shadertwin::glsl::packet
