// Integer division and shifts, and relations, with every operand defined: C++ leaves division by zero, the
// division INT_MIN / -1 and shifts by 32 and more undefined.
#pragma once

#include "reference/glsl/componentwise.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

// --- Division ---------------------------------------------------------------

// By zero: 0 for int, all bits set for uint, as llvmpipe has it. INT_MIN / -1 is INT_MIN.
SHADERTWIN_INLINE int divide(int a, int b) {
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  SHADERTWIN_PROBE(a == INT32_MIN && b == -1, integer_division_overflow);
  if (b == 0) return 0;
  return b == -1 ? static_cast<int>(0U - static_cast<uint>(a)) : a / b;
}
SHADERTWIN_INLINE uint divide(uint a, uint b) {
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  return b == 0 ? UINT32_MAX : a / b;
}
// By zero: all bits set.
SHADERTWIN_INLINE int modulo(int a, int b) {
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  if (b == 0) return -1;
  return b == -1 ? 0 : a % b;
}
SHADERTWIN_INLINE uint modulo(uint a, uint b) {
  SHADERTWIN_PROBE(b == 0, integer_division_by_zero);
  return b == 0 ? UINT32_MAX : a % b;
}

#define SHADERTWIN_DIVISION(f, family, scalar)       \
  SHADERTWIN_MAP_2(f, family, family, family)        \
  SHADERTWIN_MAP_2_SCALAR(f, family, family, scalar) \
  SHADERTWIN_MAP_SCALAR_2(f, family, scalar, family)
SHADERTWIN_DIVISION(divide, ivec, int)
SHADERTWIN_DIVISION(divide, uvec, uint)
SHADERTWIN_DIVISION(modulo, ivec, int)
SHADERTWIN_DIVISION(modulo, uvec, uint)
#undef SHADERTWIN_DIVISION

// --- Shifts -----------------------------------------------------------------

// Only the lower five bits of the amount count.
SHADERTWIN_INLINE uint shift_left(uint a, uint b) {
  SHADERTWIN_PROBE(b > 31, shift_out_of_range);
  return a << (b & 31U);
}
SHADERTWIN_INLINE uint shift_right(uint a, uint b) {
  SHADERTWIN_PROBE(b > 31, shift_out_of_range);
  return a >> (b & 31U);
}
SHADERTWIN_INLINE int shift_left(int a, uint b) {
  return static_cast<int>(shift_left(static_cast<uint>(a), b));
}
SHADERTWIN_INLINE int shift_right(int a, uint b) {
  SHADERTWIN_PROBE(b > 31, shift_out_of_range);
  return a >> (b & 31U);
}
SHADERTWIN_INLINE uint shift_left(uint a, int b) {
  return shift_left(a, static_cast<uint>(b));
}
SHADERTWIN_INLINE uint shift_right(uint a, int b) {
  return shift_right(a, static_cast<uint>(b));
}
SHADERTWIN_INLINE int shift_left(int a, int b) {
  return shift_left(a, static_cast<uint>(b));
}
SHADERTWIN_INLINE int shift_right(int a, int b) {
  return shift_right(a, static_cast<uint>(b));
}

#define SHADERTWIN_SHIFT(f)                    \
  SHADERTWIN_MAP_2(f, ivec, ivec, ivec)        \
  SHADERTWIN_MAP_2(f, ivec, ivec, uvec)        \
  SHADERTWIN_MAP_2(f, uvec, uvec, ivec)        \
  SHADERTWIN_MAP_2(f, uvec, uvec, uvec)        \
  SHADERTWIN_MAP_2_SCALAR(f, ivec, ivec, int)  \
  SHADERTWIN_MAP_2_SCALAR(f, ivec, ivec, uint) \
  SHADERTWIN_MAP_2_SCALAR(f, uvec, uvec, int)  \
  SHADERTWIN_MAP_2_SCALAR(f, uvec, uvec, uint)
SHADERTWIN_SHIFT(shift_left)
SHADERTWIN_SHIFT(shift_right)
#undef SHADERTWIN_SHIFT

// --- Relations --------------------------------------------------------------

#define SHADERTWIN_RELATION(name, operation, family)                                          \
  SHADERTWIN_INLINE bvec2 name(family##2 a, family##2 b) {                                    \
    return bvec2(a.x operation b.x, a.y operation b.y);                                       \
  }                                                                                           \
  SHADERTWIN_INLINE bvec3 name(family##3 a, family##3 b) {                                    \
    return bvec3(a.x operation b.x, a.y operation b.y, a.z operation b.z);                    \
  }                                                                                           \
  SHADERTWIN_INLINE bvec4 name(family##4 a, family##4 b) {                                    \
    return bvec4(a.x operation b.x, a.y operation b.y, a.z operation b.z, a.w operation b.w); \
  }
#define SHADERTWIN_RELATIONS(family)                \
  SHADERTWIN_RELATION(lessThan, <, family)          \
  SHADERTWIN_RELATION(lessThanEqual, <=, family)    \
  SHADERTWIN_RELATION(greaterThan, >, family)       \
  SHADERTWIN_RELATION(greaterThanEqual, >=, family) \
  SHADERTWIN_RELATION(equal, ==, family)            \
  SHADERTWIN_RELATION(notEqual, !=, family)
SHADERTWIN_RELATIONS(vec)
SHADERTWIN_RELATIONS(ivec)
SHADERTWIN_RELATIONS(uvec)
SHADERTWIN_RELATION(equal, ==, bvec)
SHADERTWIN_RELATION(notEqual, !=, bvec)

SHADERTWIN_INLINE bool any(bvec2 v) {
  return v.x || v.y;
}
SHADERTWIN_INLINE bool any(bvec3 v) {
  return v.x || v.y || v.z;
}
SHADERTWIN_INLINE bool any(bvec4 v) {
  return v.x || v.y || v.z || v.w;
}
SHADERTWIN_INLINE bool all(bvec2 v) {
  return v.x && v.y;
}
SHADERTWIN_INLINE bool all(bvec3 v) {
  return v.x && v.y && v.z;
}
SHADERTWIN_INLINE bool all(bvec4 v) {
  return v.x && v.y && v.z && v.w;
}
// `not` is a C++ keyword.
SHADERTWIN_INLINE bvec2 not_(bvec2 v) {
  return bvec2(!v.x, !v.y);
}
SHADERTWIN_INLINE bvec3 not_(bvec3 v) {
  return bvec3(!v.x, !v.y, !v.z);
}
SHADERTWIN_INLINE bvec4 not_(bvec4 v) {
  return bvec4(!v.x, !v.y, !v.z, !v.w);
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
