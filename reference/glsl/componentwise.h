// Spreads a function of scalars over the components of vectors. `result`, `first` ... are families of types:
// vec, ivec, uvec or bvec. Plain overloads and not templates: they win over GLM's templates of the same name,
// which argument-dependent lookup would find too.
#pragma once

#include "reference/glsl/types.h"

#define SHADERTWIN_MAP_1(f, result, first)            \
  SHADERTWIN_INLINE result##2 f(first##2 a) {         \
    return result##2(f(a.x), f(a.y));                 \
  }                                                   \
  SHADERTWIN_INLINE result##3 f(first##3 a) {         \
    return result##3(f(a.x), f(a.y), f(a.z));         \
  }                                                   \
  SHADERTWIN_INLINE result##4 f(first##4 a) {         \
    return result##4(f(a.x), f(a.y), f(a.z), f(a.w)); \
  }

#define SHADERTWIN_MAP_2(f, result, first, second)                        \
  SHADERTWIN_INLINE result##2 f(first##2 a, second##2 b) {                \
    return result##2(f(a.x, b.x), f(a.y, b.y));                           \
  }                                                                       \
  SHADERTWIN_INLINE result##3 f(first##3 a, second##3 b) {                \
    return result##3(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));              \
  }                                                                       \
  SHADERTWIN_INLINE result##4 f(first##4 a, second##4 b) {                \
    return result##4(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w)); \
  }

// The second operand is one scalar for all components.
#define SHADERTWIN_MAP_2_SCALAR(f, result, first, scalar)         \
  SHADERTWIN_INLINE result##2 f(first##2 a, scalar b) {           \
    return result##2(f(a.x, b), f(a.y, b));                       \
  }                                                               \
  SHADERTWIN_INLINE result##3 f(first##3 a, scalar b) {           \
    return result##3(f(a.x, b), f(a.y, b), f(a.z, b));            \
  }                                                               \
  SHADERTWIN_INLINE result##4 f(first##4 a, scalar b) {           \
    return result##4(f(a.x, b), f(a.y, b), f(a.z, b), f(a.w, b)); \
  }

// The first operand is one scalar for all components.
#define SHADERTWIN_MAP_SCALAR_2(f, result, scalar, second)        \
  SHADERTWIN_INLINE result##2 f(scalar a, second##2 b) {          \
    return result##2(f(a, b.x), f(a, b.y));                       \
  }                                                               \
  SHADERTWIN_INLINE result##3 f(scalar a, second##3 b) {          \
    return result##3(f(a, b.x), f(a, b.y), f(a, b.z));            \
  }                                                               \
  SHADERTWIN_INLINE result##4 f(scalar a, second##4 b) {          \
    return result##4(f(a, b.x), f(a, b.y), f(a, b.z), f(a, b.w)); \
  }

#define SHADERTWIN_MAP_3(f, result, first, second, third)                                     \
  SHADERTWIN_INLINE result##2 f(first##2 a, second##2 b, third##2 c) {                        \
    return result##2(f(a.x, b.x, c.x), f(a.y, b.y, c.y));                                     \
  }                                                                                           \
  SHADERTWIN_INLINE result##3 f(first##3 a, second##3 b, third##3 c) {                        \
    return result##3(f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z));                   \
  }                                                                                           \
  SHADERTWIN_INLINE result##4 f(first##4 a, second##4 b, third##4 c) {                        \
    return result##4(f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z), f(a.w, b.w, c.w)); \
  }
