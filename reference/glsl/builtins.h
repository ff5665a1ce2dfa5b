// GLSL's built-in functions of Float, int, uint and bool.
#pragma once

#include "reference/glsl/common.h"
#include "reference/glsl/exponential.h"
#include "reference/glsl/geometry.h"
#include "reference/glsl/integer.h"
#include "reference/glsl/matrix.h"
#include "reference/glsl/overloads.h"
#include "reference/glsl/packing.h"
#include "reference/glsl/trigonometry.h"
#ifdef SHADERTWIN_SHADOW
#include "reference/glsl/shadow_functions.h"
#endif

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

using Int = int;
using Uint = uint;
using Bool = bool;

#ifdef SHADERTWIN_LANES
#define SHADERTWIN_IN_LANES_1(f, type)                                 \
  SHADERTWIN_INLINE type f(type a) {                                   \
    return detail::from_lanes<type>(detail::f##_of(detail::lanes(a))); \
  }
#define SHADERTWIN_IN_LANES_2(f, type)                                                   \
  SHADERTWIN_INLINE type f(type a, type b) {                                             \
    return detail::from_lanes<type>(detail::f##_of(detail::lanes(a), detail::lanes(b))); \
  }
#define SHADERTWIN_ELEMENTARY_1(f) \
  SHADERTWIN_IN_LANES_1(f, Float)  \
  SHADERTWIN_IN_LANES_1(f, vec2)   \
  SHADERTWIN_IN_LANES_1(f, vec3)   \
  SHADERTWIN_IN_LANES_1(f, vec4)
#define SHADERTWIN_ELEMENTARY_2(f) \
  SHADERTWIN_IN_LANES_2(f, Float)  \
  SHADERTWIN_IN_LANES_2(f, vec2)   \
  SHADERTWIN_IN_LANES_2(f, vec3)   \
  SHADERTWIN_IN_LANES_2(f, vec4)
#endif
#define SHADERTWIN_INTEGERS(...) __VA_ARGS__
#include "reference/glsl/builtins.def"

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
