// GLSL's built-in functions and operators for packets, each the scalar function's operations in eight lanes.
#pragma once

#include "reference/glsl/packet_values.h"

namespace shadertwin::glsl::packet {

// --- What the built-in functions are made of (number.h) ---------------------

#ifdef __AVX__
#define SHADERTWIN_OF_LANES(name, instruction) \
  SHADERTWIN_INLINE Float name(Float x) {      \
    return Float(instruction);                 \
  }
#else
#define SHADERTWIN_OF_LANES(name, instruction)                                                        \
  SHADERTWIN_INLINE Float name(Float x) {                                                             \
    return Float(detail::each_of_eight<detail::float8>([&](int i) { return detail::name(x.v[i]); })); \
  }
#endif
SHADERTWIN_OF_LANES(root, _mm256_sqrt_ps(x.v))
SHADERTWIN_OF_LANES(round_down, _mm256_floor_ps(x.v))
SHADERTWIN_OF_LANES(round_up, _mm256_ceil_ps(x.v))
SHADERTWIN_OF_LANES(round_to_zero, _mm256_round_ps(x.v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC))
SHADERTWIN_OF_LANES(round_to_even, _mm256_round_ps(x.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC))
#undef SHADERTWIN_OF_LANES
SHADERTWIN_INLINE Float multiply_add(Float a, Float b, Float c) {
#ifdef __FMA__
  return Float(_mm256_fmadd_ps(a.v, b.v, c.v));
#else
  return a * b + c;
#endif
}
SHADERTWIN_INLINE Int to_int(Float x) {
#ifdef __AVX__
  return Int(reinterpret_cast<detail::int8>(_mm256_cvttps_epi32(x.v)));
#else
  return Int(detail::each_of_eight<detail::int8>([&](int i) { return detail::to_int(x.v[i]); }));
#endif
}
#ifdef __AVX__
SHADERTWIN_INLINE Float first_if_less(Float a, Float b) {
  return Float(_mm256_min_ps(a.v, b.v));
}
SHADERTWIN_INLINE Float first_if_greater(Float a, Float b) {
  return Float(_mm256_max_ps(a.v, b.v));
}
#endif

}  // namespace shadertwin::glsl::packet

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {
template <class T>
struct NumberTypes<packet::Packet<T>> {
  using Signed = packet::Int;
  using Unsigned = packet::Uint;
  using Mask = packet::Bool;
};
template <class T>
constexpr bool is_integer<packet::Packet<T>> = is_integer<T>;
template <>
SHADERTWIN_INLINE packet::Float from_int<packet::Float>(packet::Int x) {
  return packet::Float(__builtin_convertvector(x.v, float8));
}
static_assert(Number<packet::Float>);
}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail

namespace shadertwin::glsl::packet {

// --- Built-in functions -----------------------------------------------------

// What takes uniform arguments only is the scalar function.
#define SHADERTWIN_BUILTIN(op, f, ...) \
  using glsl::f;                       \
  __VA_ARGS__
#define SHADERTWIN_HELPER(f, ...) \
  using glsl::f;                  \
  __VA_ARGS__
#define SHADERTWIN_INTEGERS(...) __VA_ARGS__
// What has no instruction of its own goes lane by lane.
#define SHADERTWIN_LANEWISE_1(f, R, A)                                 \
  inline R f(A a) {                                                    \
    return every_lane__([&](int i) { return glsl::f(lane__(a, i)); }); \
  }
#define SHADERTWIN_LANEWISE_2(f, R, A, B)                                            \
  inline R f(A a, B b) {                                                             \
    return every_lane__([&](int i) { return glsl::f(lane__(a, i), lane__(b, i)); }); \
  }
#include "reference/glsl/builtins.def"

// GLM has a template for a weight that is no packet.
#define SHADERTWIN_MIX(type)                            \
  SHADERTWIN_INLINE type mix(type a, type b, float t) { \
    return mix(a, b, Float(t));                         \
  }
SHADERTWIN_MIX(vec2)
SHADERTWIN_MIX(vec3)
SHADERTWIN_MIX(vec4)
#undef SHADERTWIN_MIX

// --- Vectors and scalars, matrices and scalars ------------------------------

// Not templates, so that a uniform scalar becomes a packet.
#define SHADERTWIN_MIXED(op, type, scalar)                      \
  SHADERTWIN_INLINE type operator op(const type& a, scalar b) { \
    type result;                                                \
    for (int i = 0; i < a.length(); ++i) result[i] = a[i] op b; \
    return result;                                              \
  }                                                             \
  SHADERTWIN_INLINE type operator op(scalar a, const type& b) { \
    type result;                                                \
    for (int i = 0; i < b.length(); ++i) result[i] = a op b[i]; \
    return result;                                              \
  }
#define SHADERTWIN_MIXED_ARITHMETIC(type, scalar) \
  SHADERTWIN_MIXED(+, type, scalar)               \
  SHADERTWIN_MIXED(-, type, scalar)               \
  SHADERTWIN_MIXED(*, type, scalar)               \
  SHADERTWIN_MIXED(/, type, scalar)
#define SHADERTWIN_MIXED_BITS(type, scalar) \
  SHADERTWIN_MIXED_ARITHMETIC(type, scalar) \
  SHADERTWIN_MIXED(&, type, scalar)         \
  SHADERTWIN_MIXED(|, type, scalar)         \
  SHADERTWIN_MIXED(^, type, scalar)
SHADERTWIN_MIXED_ARITHMETIC(vec2, Float)
SHADERTWIN_MIXED_ARITHMETIC(vec3, Float)
SHADERTWIN_MIXED_ARITHMETIC(vec4, Float)
SHADERTWIN_MIXED_BITS(ivec2, Int)
SHADERTWIN_MIXED_BITS(ivec3, Int)
SHADERTWIN_MIXED_BITS(ivec4, Int)
SHADERTWIN_MIXED_BITS(uvec2, Uint)
SHADERTWIN_MIXED_BITS(uvec3, Uint)
SHADERTWIN_MIXED_BITS(uvec4, Uint)
SHADERTWIN_MIXED_ARITHMETIC(mat2x2, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat2x3, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat2x4, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat3x2, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat3x3, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat3x4, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat4x2, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat4x3, Float)
SHADERTWIN_MIXED_ARITHMETIC(mat4x4, Float)
// GLM subtracts from zero, which loses the sign of a zero.
#define SHADERTWIN_NEGATED(type)                            \
  SHADERTWIN_INLINE type operator-(const type& a) {         \
    type result;                                            \
    for (int i = 0; i < a.length(); ++i) result[i] = -a[i]; \
    return result;                                          \
  }
SHADERTWIN_NEGATED(vec2)
SHADERTWIN_NEGATED(vec3)
SHADERTWIN_NEGATED(ivec2)
SHADERTWIN_NEGATED(ivec3)
SHADERTWIN_NEGATED(ivec4)
SHADERTWIN_NEGATED(uvec2)
SHADERTWIN_NEGATED(uvec3)
SHADERTWIN_NEGATED(uvec4)
SHADERTWIN_NEGATED(mat2x2)
SHADERTWIN_NEGATED(mat2x3)
SHADERTWIN_NEGATED(mat2x4)
SHADERTWIN_NEGATED(mat3x2)
SHADERTWIN_NEGATED(mat3x3)
SHADERTWIN_NEGATED(mat3x4)
SHADERTWIN_NEGATED(mat4x2)
SHADERTWIN_NEGATED(mat4x3)
SHADERTWIN_NEGATED(mat4x4)
#undef SHADERTWIN_NEGATED
#undef SHADERTWIN_MIXED_BITS
#undef SHADERTWIN_MIXED_ARITHMETIC
#undef SHADERTWIN_MIXED

}  // namespace shadertwin::glsl::packet
