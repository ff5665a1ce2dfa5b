#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  samplerCube iChannel0{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = true;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 38;

#line 7 "tests/emit/shaders/cubes.glsl"
  uint hash(uint x) {
    x ^= x >> 16;
    x *= 2146121005u;
    x ^= x >> 15;
    x *= 2221713035u;
    return x ^ x >> 16;
#line 12 "tests/emit/shaders/cubes.glsl"
  }
#line 32 "twin.cpp"

#line 14 "tests/emit/shaders/cubes.glsl"
  Float signed_fraction(uint x) {
#line 14 "tests/emit/shaders/cubes.glsl"
    return Float(int(hash(x)) >> 8) * 1.1920929e-07f;
#line 14 "tests/emit/shaders/cubes.glsl"
  }
#line 40 "twin.cpp"

#line 17 "tests/emit/shaders/cubes.glsl"
  vec3 direction(uint n) {
    uint h = hash(n);
    vec3 at_ = vec3(signed_fraction(3u * n), signed_fraction(3u * n + 1u), signed_fraction(3u * n + 2u));
    vec3 corner = make<vec3>(ivec3(int(h >> 4 & 2u), int(h >> 5 & 2u), int(h >> 6 & 2u)) - 1);
    if ((n & 3u) < 2u) {
#line 21 "tests/emit/shaders/cubes.glsl"
      return corner + at_ * 0.015f;
#line 21 "tests/emit/shaders/cubes.glsl"
    }
    if ((n & 3u) == 2u) {
#line 22 "tests/emit/shaders/cubes.glsl"
      return vec3(corner.xy() + at_.xy() * 0.015f, at_.z);
#line 22 "tests/emit/shaders/cubes.glsl"
    }
    return at_;
#line 23 "tests/emit/shaders/cubes.glsl"
  }
#line 60 "twin.cpp"

#line 25 "tests/emit/shaders/cubes.glsl"
  uvec4 mixed(uvec4 sum, vec4 color) {
#line 25 "tests/emit/shaders/cubes.glsl"
    return (sum ^ floatBitsToUint(color)) * 2654435761u;
#line 25 "tests/emit/shaders/cubes.glsl"
  }
#line 68 "twin.cpp"

#line 27 "tests/emit/shaders/cubes.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 27 "tests/emit/shaders/cubes.glsl"
    unwritten(color);
    uint pixel = make<uint>(p.x) + 64u * make<uint>(p.y);
    uvec4 sum = uvec4(0u);
    vec3 d = vec3(1.0f);
    for (uint i = 0u; i < 48u; i++) {
      uint n = 48u * pixel + i;
      d = direction(n);
      sum = mixed(sum, textureLod(iChannel0, d, 0.0f));
      sum = mixed(sum, textureLod(iChannel0, d, 4.0f + 5.0f * d.y * d.z));
      if (hash(n) % 29u == 0u) {
#line 36 "tests/emit/shaders/cubes.glsl"
        break;
#line 36 "tests/emit/shaders/cubes.glsl"
      }
#line 36 "tests/emit/shaders/cubes.glsl"
    }
#line 38 "tests/emit/shaders/cubes.glsl"
    sum = mixed(sum, texture(iChannel0, d));
    sum = mixed(sum, textureGrad(iChannel0, d, dFdx(d.zxy()) * 0.1f, dFdy(d)));
    color = make<vec4>(shift_right(sum, 8)) * 5.9604645e-08f;
#line 40 "tests/emit/shaders/cubes.glsl"
  }
#line 95 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
