// Float arithmetic for the built-in functions: one number at a time; four side by side where the processor
// has registers of four (a vec3's sines then cost one sine's time, and a lone number's integer steps stay in
// its register); or eight, one of each of eight pixels. The functions are written once, as templates over F:
// float, float4 or float8.
#pragma once

#include <bit>
#include <cmath>
#include <limits>

#include "reference/glsl/componentwise.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

constexpr Float infinity = std::numeric_limits<Float>::infinity();
constexpr Float nan = std::numeric_limits<Float>::quiet_NaN();
constexpr Float half_pi = Float(1.57079632679489661923);

#ifndef SHADERTWIN_DOUBLE

// --- One number -------------------------------------------------------------

template <class F>
struct IntegersOf {
  using Signed = int;
  using Unsigned = uint;
};

// LLVM's fmuladd.
SHADERTWIN_INLINE float multiply_add(float a, float b, float c) {
#ifdef __FMA__
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}
SHADERTWIN_INLINE float round_down(float x) {
  return std::floor(x);
}
SHADERTWIN_INLINE float root(float x) {
  return std::sqrt(x);
}
SHADERTWIN_INLINE float select(bool condition, float a, float b) {
  return condition ? a : b;
}
SHADERTWIN_INLINE int to_int(float x) {
  return x != x ? 0 : x <= -2147483648.0F ? INT32_MIN : x >= 2147483648.0F ? INT32_MAX : static_cast<int>(x);
}
SHADERTWIN_INLINE float to_float(int x) {
  return static_cast<float>(x);
}

// --- Four numbers -----------------------------------------------------------

#ifdef __SSE4_1__
#define SHADERTWIN_LANES

using float4 = float __attribute__((vector_size(16)));
using int4 = int __attribute__((vector_size(16)));
using uint4 = uint __attribute__((vector_size(16)));

template <>
struct IntegersOf<float4> {
  using Signed = int4;
  using Unsigned = uint4;
};

SHADERTWIN_INLINE float4 multiply_add(float4 a, float4 b, float4 c) {
#ifdef __FMA__
  return _mm_fmadd_ps(a, b, c);
#else
  return a * b + c;
#endif
}
SHADERTWIN_INLINE float4 round_down(float4 x) {
  return _mm_floor_ps(x);
}
SHADERTWIN_INLINE float4 root(float4 x) {
  return _mm_sqrt_ps(x);
}
SHADERTWIN_INLINE float4 select(int4 condition, float4 a, float4 b) {
  return _mm_blendv_ps(b, a, reinterpret_cast<__m128>(condition));
}
SHADERTWIN_INLINE int4 to_int(float4 x) {
  return reinterpret_cast<int4>(_mm_cvttps_epi32(x));
}
SHADERTWIN_INLINE float4 to_float(int4 x) {
  return _mm_cvtepi32_ps(reinterpret_cast<__m128i>(x));
}
// x86's minps and maxps: the second operand if the two are equal or one is a NaN.
SHADERTWIN_INLINE float4 first_if_less(float4 a, float4 b) {
  return _mm_min_ps(a, b);
}
SHADERTWIN_INLINE float4 first_if_greater(float4 a, float4 b) {
  return _mm_max_ps(a, b);
}

SHADERTWIN_INLINE float4 lanes(float x) {
  return lane(x);
}
SHADERTWIN_INLINE float4 lanes(vec2 v) {
  return float4{v.x, v.y, v.y, v.y};
}
SHADERTWIN_INLINE float4 lanes(vec3 v) {
  return float4{v.x, v.y, v.z, v.z};
}
SHADERTWIN_INLINE float4 lanes(vec4 v) {
  return float4{v.x, v.y, v.z, v.w};
}
template <class T>
SHADERTWIN_INLINE T from_lanes(float4 r) {
  if constexpr (std::is_same_v<T, float>) {
    return r[0];
  } else if constexpr (std::is_same_v<T, vec2>) {
    return vec2(r[0], r[1]);
  } else if constexpr (std::is_same_v<T, vec3>) {
    return vec3(r[0], r[1], r[2]);
  } else {
    return vec4(r[0], r[1], r[2], r[3]);
  }
}
#endif

// --- Eight numbers ----------------------------------------------------------

// One of each of eight pixels: what packet.h is made of. Without AVX the compiler makes two registers of it.
using float8 = float __attribute__((vector_size(32)));
using int8 = int __attribute__((vector_size(32)));
using uint8 = uint __attribute__((vector_size(32)));

template <>
struct IntegersOf<float8> {
  using Signed = int8;
  using Unsigned = uint8;
};

template <class Result, class Function>
SHADERTWIN_INLINE Result each_of_eight(const Function& function) {
  Result result{};
  for (int i = 0; i < 8; ++i) result[i] = function(i);
  return result;
}

SHADERTWIN_INLINE float8 multiply_add(float8 a, float8 b, float8 c) {
#ifdef __FMA__
  return _mm256_fmadd_ps(a, b, c);
#else
  return a * b + c;
#endif
}
SHADERTWIN_INLINE float8 root(float8 x) {
#ifdef __AVX__
  return _mm256_sqrt_ps(x);
#else
  return each_of_eight<float8>([&](int i) { return root(x[i]); });
#endif
}
// `condition` is all ones or all zeros in each place.
SHADERTWIN_INLINE float8 select(int8 condition, float8 a, float8 b) {
#ifdef __AVX__
  return _mm256_blendv_ps(b, a, reinterpret_cast<__m256>(condition));
#else
  const int8 bits = (std::bit_cast<int8>(a) & condition) | (std::bit_cast<int8>(b) & ~condition);
  return std::bit_cast<float8>(bits);
#endif
}
SHADERTWIN_INLINE float8 round_down(float8 x) {
#ifdef __AVX__
  return _mm256_floor_ps(x);
#else
  return each_of_eight<float8>([&](int i) { return round_down(x[i]); });
#endif
}
SHADERTWIN_INLINE int8 to_int(float8 x) {
#ifdef __AVX__
  return reinterpret_cast<int8>(_mm256_cvttps_epi32(x));
#else
  return each_of_eight<int8>([&](int i) { return to_int(x[i]); });
#endif
}
SHADERTWIN_INLINE float8 to_float(int8 x) {
  return __builtin_convertvector(x, float8);
}
SHADERTWIN_INLINE float8 first_if_less(float8 a, float8 b) {
#ifdef __AVX__
  return _mm256_min_ps(a, b);
#else
  return select(a < b, a, b);
#endif
}
SHADERTWIN_INLINE float8 first_if_greater(float8 a, float8 b) {
#ifdef __AVX__
  return _mm256_max_ps(a, b);
#else
  return select(a > b, a, b);
#endif
}

template <class F>
SHADERTWIN_INLINE F constant(float x) {
  return F{} + x;
}
template <>
SHADERTWIN_INLINE float constant<float>(float x) {
  return x;
}

template <class F>
using Signed = typename IntegersOf<F>::Signed;
template <class F>
using Unsigned = typename IntegersOf<F>::Unsigned;

template <class F>
SHADERTWIN_INLINE Unsigned<F> bits(F x) {
  return std::bit_cast<Unsigned<F>>(x);
}
template <class F>
SHADERTWIN_INLINE F from_bits(Unsigned<F> x) {
  return std::bit_cast<F>(x);
}
template <class F>
SHADERTWIN_INLINE F magnitude_of(F x) {
  return from_bits<F>(bits(x) & 0x7fffffffU);
}
template <class F>
SHADERTWIN_INLINE F negated(F x) {
  return from_bits<F>(bits(x) ^ 0x80000000U);
}

#endif

// --- Smaller and larger of one number ---------------------------------------

#if defined(__SSE2__) && !defined(SHADERTWIN_DOUBLE)
SHADERTWIN_INLINE float first_if_less(float a, float b) {
  return _mm_cvtss_f32(_mm_min_ss(lane(a), lane(b)));
}
SHADERTWIN_INLINE float first_if_greater(float a, float b) {
  return _mm_cvtss_f32(_mm_max_ss(lane(a), lane(b)));
}
#else
SHADERTWIN_INLINE Float first_if_less(Float a, Float b) {
  return a < b ? a : b;
}
SHADERTWIN_INLINE Float first_if_greater(Float a, Float b) {
  return a > b ? a : b;
}
#endif

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail

// Calls a template detail::implementation<F> for an argument of type T: Float or vecN.
#ifdef SHADERTWIN_LANES
#define SHADERTWIN_APPLY_1(T, implementation, a) \
  detail::from_lanes<T>(detail::implementation<detail::float4>(detail::lanes(a)))
#define SHADERTWIN_APPLY_2(T, implementation, a, b) \
  detail::from_lanes<T>(detail::implementation<detail::float4>(detail::lanes(a), detail::lanes(b)))
#else
#define SHADERTWIN_APPLY_1(T, implementation, a) detail::implementation<T>(a)
#define SHADERTWIN_APPLY_2(T, implementation, a, b) detail::implementation<T>(a, b)
#endif

// Spreads f, a function of Float that calls detail::implementation, over vec2 to vec4. With probes each
// component goes through f itself.
#if defined(SHADERTWIN_LANES) && !defined(SHADERTWIN_CHECK)
#define SHADERTWIN_SPREAD_1(f, implementation)          \
  SHADERTWIN_INLINE vec2 f(vec2 a) {                    \
    return SHADERTWIN_APPLY_1(vec2, implementation, a); \
  }                                                     \
  SHADERTWIN_INLINE vec3 f(vec3 a) {                    \
    return SHADERTWIN_APPLY_1(vec3, implementation, a); \
  }                                                     \
  SHADERTWIN_INLINE vec4 f(vec4 a) {                    \
    return SHADERTWIN_APPLY_1(vec4, implementation, a); \
  }
#define SHADERTWIN_SPREAD_2(f, implementation)             \
  SHADERTWIN_INLINE vec2 f(vec2 a, vec2 b) {               \
    return SHADERTWIN_APPLY_2(vec2, implementation, a, b); \
  }                                                        \
  SHADERTWIN_INLINE vec3 f(vec3 a, vec3 b) {               \
    return SHADERTWIN_APPLY_2(vec3, implementation, a, b); \
  }                                                        \
  SHADERTWIN_INLINE vec4 f(vec4 a, vec4 b) {               \
    return SHADERTWIN_APPLY_2(vec4, implementation, a, b); \
  }
#else
#define SHADERTWIN_SPREAD_1(f, implementation) SHADERTWIN_MAP_1(f, vec, vec)
#define SHADERTWIN_SPREAD_2(f, implementation) SHADERTWIN_MAP_2(f, vec, vec, vec)
#endif
