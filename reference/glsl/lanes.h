// Four floats side by side, where the processor has registers of four, as a type of numbers for the
// elementary functions: a vec3's sines then cost one sine's time, and a lone number's integer steps stay in
// its register.
#pragma once

#include "reference/glsl/number.h"

// With probes and shadows each component goes through a function of its own.
#if defined(__SSE4_1__) && !defined(SHADERTWIN_DOUBLE) && !defined(SHADERTWIN_SHADOW) && \
    !defined(SHADERTWIN_CHECK)
#define SHADERTWIN_LANES

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail {

using float4 = float __attribute__((vector_size(16)));
using int4 = int __attribute__((vector_size(16)));
using uint4 = uint __attribute__((vector_size(16)));

template <>
struct NumberTypes<float4> {
  using Signed = int4;
  using Unsigned = uint4;
  using Mask = int4;
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
SHADERTWIN_INLINE float4 select__(int4 condition, float4 a, float4 b) {
  return _mm_blendv_ps(b, a, reinterpret_cast<__m128>(condition));
}
SHADERTWIN_INLINE int4 to_int(float4 x) {
  return reinterpret_cast<int4>(_mm_cvttps_epi32(x));
}
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

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION::detail
#endif
