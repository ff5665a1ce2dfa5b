// What functions of a shader need when they are called alone, outside of any picture.
#pragma once

#include "reference/glsl/glsl.h"
#include "reference/twin/unwritten.h"

namespace shadertwin::glsl {

// What `discard` throws.
struct Discarded {};

[[noreturn]] inline void stop_invocation__() {
  throw Discarded{};
}

// There are no neighbouring pixels: nothing changes from one to the next.
template <class T>
T dFdx(const T& /*value*/) {
  return T(0);
}
template <class T>
T dFdy(const T& /*value*/) {
  return T(0);
}
template <class T>
T fwidth(const T& /*value*/) {
  return T(0);
}

// Textures are read at their base level.
template <class Sampler, class P>
vec4 texture(const Sampler& s, P p) {
  return texture(s, p, Lod{});
}
template <class Sampler, class P>
vec4 texture(const Sampler& s, P p, Float bias) {
  return texture(s, p, Lod{}, bias);
}
template <class Sampler, class P, class Offset>
vec4 textureOffset(const Sampler& s, P p, Offset offset) {
  return textureOffset(s, p, Lod{}, offset);
}
template <class Sampler, class P>
vec4 textureProj(const Sampler& s, P p) {
  return textureProj(s, p, Lod{});
}

inline const vec4 gl_FragCoord = vec4(0.5, 0.5, 0.5, 1.0);

}  // namespace shadertwin::glsl
