// GLSL's built-in functions for packets, each the scalar function's operations in eight lanes.
#pragma once

#include "reference/glsl/packet.h"

namespace shadertwin::glsl::packet {

// What takes uniform arguments only is the scalar function. Plain overloads win over GLM's templates.
using glsl::abs, glsl::acos, glsl::acosh, glsl::all, glsl::any, glsl::asin, glsl::asinh, glsl::atan,
    glsl::atanh, glsl::ceil, glsl::clamp, glsl::cos, glsl::cosh, glsl::cross, glsl::degrees,
    glsl::determinant, glsl::distance, glsl::divide, glsl::dot, glsl::equal, glsl::exp, glsl::exp2,
    glsl::faceforward, glsl::floatBitsToInt, glsl::floatBitsToUint, glsl::floor, glsl::fract,
    glsl::greaterThan, glsl::greaterThanEqual, glsl::intBitsToFloat, glsl::inverse, glsl::inversesqrt,
    glsl::isinf, glsl::isnan, glsl::length, glsl::lessThan, glsl::lessThanEqual, glsl::log, glsl::log2,
    glsl::matrixCompMult, glsl::max, glsl::min, glsl::mix, glsl::mix_strict, glsl::mod, glsl::modf,
    glsl::modulo, glsl::normalize, glsl::not_, glsl::notEqual, glsl::outerProduct, glsl::packHalf2x16,
    glsl::packSnorm2x16, glsl::packUnorm2x16, glsl::pow, glsl::radians, glsl::reflect, glsl::refract,
    glsl::round, glsl::roundEven, glsl::shift_left, glsl::shift_right, glsl::sign, glsl::sin, glsl::sinh,
    glsl::smoothstep, glsl::sqrt, glsl::step, glsl::tan, glsl::tanh, glsl::transpose, glsl::trunc,
    glsl::uintBitsToFloat, glsl::unpackHalf2x16, glsl::unpackSnorm2x16, glsl::unpackUnorm2x16;
using glsl::operator-;
using glsl::operator*;
using glsl::operator/;

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
// GLM's subtracts from zero, which loses the sign of a zero.
#define SHADERTWIN_NEGATED(type)                            \
  SHADERTWIN_INLINE type operator-(const type& a) {         \
    type result;                                            \
    for (int i = 0; i < a.length(); ++i) result[i] = -a[i]; \
    return result;                                          \
  }
SHADERTWIN_NEGATED(vec2)
SHADERTWIN_NEGATED(vec3)
SHADERTWIN_NEGATED(vec4)
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

// --- Magnitude and rounding -------------------------------------------------

#ifdef __AVX__
#define SHADERTWIN_ROUND(name, instruction, scalar) \
  SHADERTWIN_INLINE Float name(Float x) {           \
    return Float(instruction);                      \
  }
#else
#define SHADERTWIN_ROUND(name, instruction, scalar)                   \
  SHADERTWIN_INLINE Float name(Float x) {                             \
    return every_lane__([&](int i) { return glsl::scalar(x.v[i]); }); \
  }
#endif
SHADERTWIN_ROUND(floor, _mm256_floor_ps(x.v), floor)
SHADERTWIN_ROUND(ceil, _mm256_ceil_ps(x.v), ceil)
SHADERTWIN_ROUND(trunc, _mm256_round_ps(x.v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC), trunc)
SHADERTWIN_ROUND(roundEven, _mm256_round_ps(x.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC), roundEven)
SHADERTWIN_ROUND(round, _mm256_round_ps(x.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC), round)
#undef SHADERTWIN_ROUND

SHADERTWIN_INLINE Float abs(Float x) {
  return Float(detail::magnitude_of(x.v));
}
SHADERTWIN_INLINE Int abs(Int x) {
  return select__(x < Int(0), -x, x);
}
SHADERTWIN_INLINE Float sign(Float x) {
  return select__(x > 0.0F, 1.0F, select__(x < 0.0F, Float(-1.0F), 0.0F));
}
SHADERTWIN_INLINE Int sign(Int x) {
  return select__(x > 0, 1, select__(x < 0, Int(-1), 0));
}
SHADERTWIN_INLINE Float fract(Float x) {
  return x - floor(x);
}
SHADERTWIN_INLINE Float mod(Float x, Float y) {
  return x - y * floor(x / y);
}
SHADERTWIN_MAP_1(abs, vec, vec)
SHADERTWIN_MAP_1(abs, ivec, ivec)
SHADERTWIN_MAP_1(sign, vec, vec)
SHADERTWIN_MAP_1(sign, ivec, ivec)
SHADERTWIN_MAP_1(floor, vec, vec)
SHADERTWIN_MAP_1(ceil, vec, vec)
SHADERTWIN_MAP_1(trunc, vec, vec)
SHADERTWIN_MAP_1(roundEven, vec, vec)
SHADERTWIN_MAP_1(round, vec, vec)
SHADERTWIN_MAP_1(fract, vec, vec)
SHADERTWIN_MAP_2(mod, vec, vec, vec)
SHADERTWIN_MAP_2_SCALAR(mod, vec, vec, Float)
// `whole` is the function's own: the emitter assigns it under the caller's mask.
#define SHADERTWIN_MODF(type)                               \
  SHADERTWIN_INLINE type modf(const type& x, type& whole) { \
    whole = trunc(x);                                       \
    return x - whole;                                       \
  }
SHADERTWIN_MODF(Float)
SHADERTWIN_MODF(vec2)
SHADERTWIN_MODF(vec3)
SHADERTWIN_MODF(vec4)
#undef SHADERTWIN_MODF

// --- Smaller and larger -----------------------------------------------------

SHADERTWIN_INLINE Float min(Float a, Float b) {
  return select__(b != b, a, Float(detail::first_if_less(a.v, b.v)));
}
SHADERTWIN_INLINE Float max(Float a, Float b) {
  return select__(b != b, a, Float(detail::first_if_greater(a.v, b.v)));
}
#define SHADERTWIN_SMALLER(type)               \
  SHADERTWIN_INLINE type min(type a, type b) { \
    return select__(a < b, a, b);              \
  }                                            \
  SHADERTWIN_INLINE type max(type a, type b) { \
    return select__(a > b, a, b);              \
  }
SHADERTWIN_SMALLER(Int)
SHADERTWIN_SMALLER(Uint)
#undef SHADERTWIN_SMALLER

#define SHADERTWIN_ORDER(family, scalar)                                                   \
  SHADERTWIN_INLINE scalar clamp(scalar x, scalar low, scalar high) {                      \
    return min(max(x, low), high);                                                         \
  }                                                                                        \
  SHADERTWIN_MAP_2(min, family, family, family)                                            \
  SHADERTWIN_MAP_2_SCALAR(min, family, family, scalar)                                     \
  SHADERTWIN_MAP_2(max, family, family, family)                                            \
  SHADERTWIN_MAP_2_SCALAR(max, family, family, scalar)                                     \
  SHADERTWIN_MAP_3(clamp, family, family, family, family)                                  \
  SHADERTWIN_INLINE family##2 clamp(family##2 x, scalar low, scalar high) {                \
    return family##2(clamp(x.x, low, high), clamp(x.y, low, high));                        \
  }                                                                                        \
  SHADERTWIN_INLINE family##3 clamp(family##3 x, scalar low, scalar high) {                \
    return family##3(clamp(x.x, low, high), clamp(x.y, low, high), clamp(x.z, low, high)); \
  }                                                                                        \
  SHADERTWIN_INLINE family##4 clamp(family##4 x, scalar low, scalar high) {                \
    return family##4(clamp(x.x, low, high), clamp(x.y, low, high), clamp(x.z, low, high),  \
                     clamp(x.w, low, high));                                               \
  }
SHADERTWIN_ORDER(vec, Float)
SHADERTWIN_ORDER(ivec, Int)
SHADERTWIN_ORDER(uvec, Uint)
#undef SHADERTWIN_ORDER

// --- Blending ---------------------------------------------------------------

SHADERTWIN_INLINE Float mix(Float a, Float b, Float t) {
  return a + t * (b - a);
}
SHADERTWIN_INLINE Float mix_strict(Float a, Float b, Float t) {
  return a * (1.0F - t) + b * t;
}
SHADERTWIN_INLINE Float mix(Float a, Float b, Bool second) {
  return select__(second, b, a);
}
SHADERTWIN_INLINE Float step(Float edge, Float x) {
  return select__(x >= edge, 1.0F, 0.0F);
}
SHADERTWIN_INLINE Float smoothstep(Float edge0, Float edge1, Float x) {
  const Float t = min(max((x - edge0) / (edge1 - edge0), 0.0F), 1.0F);
  return t * (t * (3.0F - 2.0F * t));
}
SHADERTWIN_MAP_3(mix, vec, vec, vec, vec)
SHADERTWIN_MAP_3(mix, vec, vec, vec, bvec)
SHADERTWIN_MAP_3(mix_strict, vec, vec, vec, vec)
SHADERTWIN_MAP_2(step, vec, vec, vec)
SHADERTWIN_MAP_SCALAR_2(step, vec, Float, vec)
SHADERTWIN_MAP_3(smoothstep, vec, vec, vec, vec)
#define SHADERTWIN_BLEND(N)                                                                   \
  SHADERTWIN_INLINE vec##N mix(vec##N a, vec##N b, Float t) {                                 \
    return mix(a, b, vec##N(t));                                                              \
  }                                                                                           \
  SHADERTWIN_INLINE vec##N mix(vec##N a, vec##N b, float t) { /* GLM has a template for it */ \
    return mix(a, b, vec##N(t));                                                              \
  }                                                                                           \
  SHADERTWIN_INLINE vec##N mix_strict(vec##N a, vec##N b, Float t) {                          \
    return mix_strict(a, b, vec##N(t));                                                       \
  }                                                                                           \
  SHADERTWIN_INLINE vec##N smoothstep(Float edge0, Float edge1, vec##N x) {                   \
    return smoothstep(vec##N(edge0), vec##N(edge1), x);                                       \
  }
SHADERTWIN_BLEND(2)
SHADERTWIN_BLEND(3)
SHADERTWIN_BLEND(4)
#undef SHADERTWIN_BLEND

// --- Classification and bits ------------------------------------------------

SHADERTWIN_INLINE Bool isnan(Float x) {
  return x != x;
}
SHADERTWIN_INLINE Bool isinf(Float x) {
  return abs(x) == detail::infinity;
}
SHADERTWIN_INLINE Int floatBitsToInt(Float x) {
  return Int(std::bit_cast<detail::int8>(x.v));
}
SHADERTWIN_INLINE Uint floatBitsToUint(Float x) {
  return Uint(std::bit_cast<detail::uint8>(x.v));
}
SHADERTWIN_INLINE Float intBitsToFloat(Int x) {
  return Float(std::bit_cast<detail::float8>(x.v));
}
SHADERTWIN_INLINE Float uintBitsToFloat(Uint x) {
  return Float(std::bit_cast<detail::float8>(x.v));
}
SHADERTWIN_MAP_1(isnan, bvec, vec)
SHADERTWIN_MAP_1(isinf, bvec, vec)
SHADERTWIN_MAP_1(floatBitsToInt, ivec, vec)
SHADERTWIN_MAP_1(floatBitsToUint, uvec, vec)
SHADERTWIN_MAP_1(intBitsToFloat, vec, ivec)
SHADERTWIN_MAP_1(uintBitsToFloat, vec, uvec)

#define SHADERTWIN_PACK(name, result, argument)                           \
  inline result name(argument x) {                                        \
    return every_lane__([&](int i) { return glsl::name(lane__(x, i)); }); \
  }
SHADERTWIN_PACK(packHalf2x16, Uint, vec2)
SHADERTWIN_PACK(packSnorm2x16, Uint, vec2)
SHADERTWIN_PACK(packUnorm2x16, Uint, vec2)
SHADERTWIN_PACK(unpackHalf2x16, vec2, Uint)
SHADERTWIN_PACK(unpackSnorm2x16, vec2, Uint)
SHADERTWIN_PACK(unpackUnorm2x16, vec2, Uint)
#undef SHADERTWIN_PACK

// --- Roots, exponentials, angles --------------------------------------------

SHADERTWIN_INLINE Float sqrt(Float x) {
  return Float(detail::root(x.v));
}
SHADERTWIN_INLINE Float inversesqrt(Float x) {
  return 1.0F / sqrt(x);
}
SHADERTWIN_INLINE Float radians(Float degrees) {
  return degrees * 0.017453292519943295769F;
}
SHADERTWIN_INLINE Float degrees(Float radians) {
  return radians * 57.295779513082320877F;
}
SHADERTWIN_MAP_1(sqrt, vec, vec)
SHADERTWIN_MAP_1(inversesqrt, vec, vec)
SHADERTWIN_MAP_1(radians, vec, vec)
SHADERTWIN_MAP_1(degrees, vec, vec)

#define SHADERTWIN_TRANSCENDENTAL_1(name)                 \
  SHADERTWIN_INLINE Float name(Float x) {                 \
    return Float(detail::name##_of<detail::float8>(x.v)); \
  }                                                       \
  SHADERTWIN_MAP_1(name, vec, vec)
SHADERTWIN_TRANSCENDENTAL_1(exp)
SHADERTWIN_TRANSCENDENTAL_1(exp2)
SHADERTWIN_TRANSCENDENTAL_1(log)
SHADERTWIN_TRANSCENDENTAL_1(log2)
SHADERTWIN_TRANSCENDENTAL_1(sin)
SHADERTWIN_TRANSCENDENTAL_1(cos)
SHADERTWIN_TRANSCENDENTAL_1(tan)
SHADERTWIN_TRANSCENDENTAL_1(asin)
SHADERTWIN_TRANSCENDENTAL_1(acos)
SHADERTWIN_TRANSCENDENTAL_1(atan)
SHADERTWIN_TRANSCENDENTAL_1(sinh)
SHADERTWIN_TRANSCENDENTAL_1(cosh)
SHADERTWIN_TRANSCENDENTAL_1(tanh)
SHADERTWIN_TRANSCENDENTAL_1(asinh)
SHADERTWIN_TRANSCENDENTAL_1(acosh)
SHADERTWIN_TRANSCENDENTAL_1(atanh)
#undef SHADERTWIN_TRANSCENDENTAL_1
SHADERTWIN_INLINE Float pow(Float x, Float y) {
  return Float(detail::pow_of<detail::float8>(x.v, y.v));
}
SHADERTWIN_INLINE Float atan(Float y, Float x) {
  return Float(detail::atan2_of<detail::float8>(y.v, x.v));
}
SHADERTWIN_MAP_2(pow, vec, vec, vec)
SHADERTWIN_MAP_2(atan, vec, vec, vec)

// --- Geometry ---------------------------------------------------------------

SHADERTWIN_INLINE Float dot(Float a, Float b) {
  return a * b;
}
SHADERTWIN_INLINE Float dot(const vec2& a, const vec2& b) {
  return a.x * b.x + a.y * b.y;
}
SHADERTWIN_INLINE Float dot(const vec3& a, const vec3& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
SHADERTWIN_INLINE Float dot(const vec4& a, const vec4& b) {
  return a.x * b.x + (a.y * b.y + (a.z * b.z + a.w * b.w));
}
SHADERTWIN_INLINE vec3 cross(const vec3& a, const vec3& b) {
  return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
SHADERTWIN_INLINE Float length(Float x) {
  return sqrt(x * x);
}
SHADERTWIN_INLINE Float distance(Float a, Float b) {
  return abs(a - b);
}
SHADERTWIN_INLINE Float normalize(Float x) {
  return sign(x);
}
SHADERTWIN_INLINE Float faceforward(Float n, Float incident, Float reference) {
  return select__(reference * incident < 0.0F, n, -n);
}
SHADERTWIN_INLINE Float reflect(Float incident, Float n) {
  return incident - 2.0F * (n * incident * n);
}
SHADERTWIN_INLINE Float refract(Float incident, Float n, Float eta) {
  const Float d = n * incident;
  const Float k = 1.0F - eta * (eta * (1.0F - d * d));
  return select__(k < 0.0F, 0.0F, eta * incident - (eta * d + sqrt(k)) * n);
}
#define SHADERTWIN_GEOMETRY(N)                                                                             \
  SHADERTWIN_INLINE Float length(const vec##N& v) {                                                        \
    return sqrt(dot(v, v));                                                                                \
  }                                                                                                        \
  SHADERTWIN_INLINE Float distance(const vec##N& a, const vec##N& b) {                                     \
    return length(a - b);                                                                                  \
  }                                                                                                        \
  SHADERTWIN_INLINE vec##N normalize(const vec##N& v) {                                                    \
    return v * (1.0F / sqrt(dot(v, v)));                                                                   \
  }                                                                                                        \
  SHADERTWIN_INLINE vec##N faceforward(const vec##N& n, const vec##N& incident, const vec##N& reference) { \
    return select__(dot(reference, incident) < 0.0F, n, -n);                                               \
  }                                                                                                        \
  SHADERTWIN_INLINE vec##N reflect(const vec##N& incident, const vec##N& n) {                              \
    return incident - (2.0F * dot(n, incident)) * n;                                                       \
  }                                                                                                        \
  SHADERTWIN_INLINE vec##N refract(const vec##N& incident, const vec##N& n, Float eta) {                   \
    const Float d = dot(n, incident);                                                                      \
    const Float k = 1.0F - eta * (eta * (1.0F - d * d));                                                   \
    return select__(k < 0.0F, vec##N(0.0F), eta * incident - (eta * d + sqrt(k)) * n);                     \
  }
SHADERTWIN_GEOMETRY(2)
SHADERTWIN_GEOMETRY(3)
SHADERTWIN_GEOMETRY(4)
#undef SHADERTWIN_GEOMETRY

// --- Matrices ---------------------------------------------------------------

SHADERTWIN_PRODUCTS(2, 2)
SHADERTWIN_PRODUCTS(2, 3)
SHADERTWIN_PRODUCTS(2, 4)
SHADERTWIN_PRODUCTS(3, 2)
SHADERTWIN_PRODUCTS(3, 3)
SHADERTWIN_PRODUCTS(3, 4)
SHADERTWIN_PRODUCTS(4, 2)
SHADERTWIN_PRODUCTS(4, 3)
SHADERTWIN_PRODUCTS(4, 4)
SHADERTWIN_MATRIX(2, 2)
SHADERTWIN_MATRIX(2, 3)
SHADERTWIN_MATRIX(2, 4)
SHADERTWIN_MATRIX(3, 2)
SHADERTWIN_MATRIX(3, 3)
SHADERTWIN_MATRIX(3, 4)
SHADERTWIN_MATRIX(4, 2)
SHADERTWIN_MATRIX(4, 3)
SHADERTWIN_MATRIX(4, 4)
#define SHADERTWIN_SQUARE(type)             \
  inline Float determinant(const type& m) { \
    return detail::determinant_of(m);       \
  }                                         \
  inline type inverse(const type& m) {      \
    return detail::inverse_of(m);           \
  }
SHADERTWIN_SQUARE(mat2)
SHADERTWIN_SQUARE(mat3)
SHADERTWIN_SQUARE(mat4)
#undef SHADERTWIN_SQUARE

// --- Integers and relations -------------------------------------------------

// Division has no instruction of its own: lane by lane.
#define SHADERTWIN_LANES_2(f, family, scalar)                            \
  inline scalar f(scalar a, scalar b) {                                  \
    return every_lane__([&](int i) { return glsl::f(a.v[i], b.v[i]); }); \
  }                                                                      \
  SHADERTWIN_MAP_2(f, family, family, family)                            \
  SHADERTWIN_MAP_2_SCALAR(f, family, family, scalar)                     \
  SHADERTWIN_MAP_SCALAR_2(f, family, scalar, family)
SHADERTWIN_LANES_2(divide, ivec, Int)
SHADERTWIN_LANES_2(divide, uvec, Uint)
SHADERTWIN_LANES_2(modulo, ivec, Int)
SHADERTWIN_LANES_2(modulo, uvec, Uint)
#undef SHADERTWIN_LANES_2

#define SHADERTWIN_SHIFT_OF(value, amount)                                \
  SHADERTWIN_INLINE value shift_left(value a, amount b) {                 \
    return value(a.v << std::bit_cast<typename value::Vector>(b.v & 31)); \
  }                                                                       \
  SHADERTWIN_INLINE value shift_right(value a, amount b) {                \
    return value(a.v >> std::bit_cast<typename value::Vector>(b.v & 31)); \
  }
SHADERTWIN_SHIFT_OF(Int, Int)
SHADERTWIN_SHIFT_OF(Int, Uint)
SHADERTWIN_SHIFT_OF(Uint, Int)
SHADERTWIN_SHIFT_OF(Uint, Uint)
#undef SHADERTWIN_SHIFT_OF
#define SHADERTWIN_SHIFT(f)                    \
  SHADERTWIN_MAP_2(f, ivec, ivec, ivec)        \
  SHADERTWIN_MAP_2(f, ivec, ivec, uvec)        \
  SHADERTWIN_MAP_2(f, uvec, uvec, ivec)        \
  SHADERTWIN_MAP_2(f, uvec, uvec, uvec)        \
  SHADERTWIN_MAP_2_SCALAR(f, ivec, ivec, Int)  \
  SHADERTWIN_MAP_2_SCALAR(f, ivec, ivec, Uint) \
  SHADERTWIN_MAP_2_SCALAR(f, uvec, uvec, Int)  \
  SHADERTWIN_MAP_2_SCALAR(f, uvec, uvec, Uint)
SHADERTWIN_SHIFT(shift_left)
SHADERTWIN_SHIFT(shift_right)
#undef SHADERTWIN_SHIFT

SHADERTWIN_RELATIONS(vec)
SHADERTWIN_RELATIONS(ivec)
SHADERTWIN_RELATIONS(uvec)
SHADERTWIN_RELATION(equal, ==, bvec)
SHADERTWIN_RELATION(notEqual, !=, bvec)

SHADERTWIN_INLINE Bool any(const bvec2& v) {
  return v.x || v.y;
}
SHADERTWIN_INLINE Bool any(const bvec3& v) {
  return v.x || v.y || v.z;
}
SHADERTWIN_INLINE Bool any(const bvec4& v) {
  return v.x || v.y || v.z || v.w;
}
SHADERTWIN_INLINE Bool all(const bvec2& v) {
  return v.x && v.y;
}
SHADERTWIN_INLINE Bool all(const bvec3& v) {
  return v.x && v.y && v.z;
}
SHADERTWIN_INLINE Bool all(const bvec4& v) {
  return v.x && v.y && v.z && v.w;
}
SHADERTWIN_INLINE Bool not_(Bool x) {
  return !x;
}
SHADERTWIN_MAP_1(not_, bvec, bvec)

}  // namespace shadertwin::glsl::packet
