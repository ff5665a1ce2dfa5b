#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  samplerCube iChannel0{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  Uint hash(Bool active, Uint x) {
    x = x ^ x >> 16;
    x = x * 2146121005u;
    x = x ^ x >> 15;
    x = x * 2221713035u;
    return x ^ x >> 16;
#line 12 "tests/emit/shaders/cubes.glsl"
  }
#line 32 "twin.cpp"

#line 14 "tests/emit/shaders/cubes.glsl"
  Float signed_fraction(Bool active, Uint x) {
#line 14 "tests/emit/shaders/cubes.glsl"
    return make<Float>(make<Int>(hash(active, x)) >> 8) * 1.1920929e-07f;
#line 14 "tests/emit/shaders/cubes.glsl"
  }
#line 40 "twin.cpp"

#line 17 "tests/emit/shaders/cubes.glsl"
  vec3 direction(Bool active, Uint n) {
#line 17 "tests/emit/shaders/cubes.glsl"
    vec3 result{};
    Uint h = hash(active, n);
    vec3 at_ = vec3(signed_fraction(active, 3u * n), signed_fraction(active, 3u * n + 1u), signed_fraction(active, 3u * n + 2u));
    vec3 corner = make<vec3>(ivec3(make<Int>(h >> 4 & 2u), make<Int>(h >> 5 & 2u), make<Int>(h >> 6 & 2u)) - 1);
    if (Bool active_2 = active && ((n & 3u) < 2u); any__(active_2)) {
#line 21 "tests/emit/shaders/cubes.glsl"
      set__(active_2, result, corner + at_ * 0.015f);
#line 21 "tests/emit/shaders/cubes.glsl"
      mask_out__(active_2, active);
#line 21 "tests/emit/shaders/cubes.glsl"
    }
#line 21 "tests/emit/shaders/cubes.glsl"
    if (none__(active)) return result;
    if (Bool active_2 = active && ((n & 3u) == 2u); any__(active_2)) {
#line 22 "tests/emit/shaders/cubes.glsl"
      set__(active_2, result, vec3(corner.xy() + at_.xy() * 0.015f, at_.z));
#line 22 "tests/emit/shaders/cubes.glsl"
      mask_out__(active_2, active);
#line 22 "tests/emit/shaders/cubes.glsl"
    }
#line 22 "tests/emit/shaders/cubes.glsl"
    if (none__(active)) return result;
    set__(active, result, at_);
#line 23 "tests/emit/shaders/cubes.glsl"
    return result;
#line 23 "tests/emit/shaders/cubes.glsl"
  }
#line 72 "twin.cpp"

#line 25 "tests/emit/shaders/cubes.glsl"
  uvec4 mixed(Bool active, uvec4 sum, vec4 color) {
#line 25 "tests/emit/shaders/cubes.glsl"
    return (sum ^ floatBitsToUint(color)) * 2654435761u;
#line 25 "tests/emit/shaders/cubes.glsl"
  }
#line 80 "twin.cpp"

#line 27 "tests/emit/shaders/cubes.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 27 "tests/emit/shaders/cubes.glsl"
    unwritten(active, color);
    Uint pixel = make<Uint>(p.x) + 64u * make<Uint>(p.y);
    uvec4 sum = uvec4(0u);
    vec3 d = vec3(1.0f);
    {
#line 31 "tests/emit/shaders/cubes.glsl"
      Bool loop = active;
#line 31 "tests/emit/shaders/cubes.glsl"
      uint i = 0u;
#line 31 "tests/emit/shaders/cubes.glsl"
      for (;; i++) {
#line 31 "tests/emit/shaders/cubes.glsl"
        loop = loop && (i < 48u);
#line 31 "tests/emit/shaders/cubes.glsl"
        if (none__(loop)) break;
#line 31 "tests/emit/shaders/cubes.glsl"
        Bool active_2 = loop;
        Uint n = 48u * pixel + i;
        set__(active_2, d, direction(active_2, n));
        set__(active_2, sum, mixed(active_2, sum, textureLod(active_2, iChannel0, d, 0.0f)));
        set__(active_2, sum, mixed(active_2, sum, textureLod(active_2, iChannel0, d, 4.0f + 5.0f * d.y * d.z)));
        if (Bool active_3 = active_2 && (hash(active_2, n) % 29u == 0u); any__(active_3)) {
#line 36 "tests/emit/shaders/cubes.glsl"
          mask_out__(active_3, active_2, loop);
#line 36 "tests/emit/shaders/cubes.glsl"
        }
#line 36 "tests/emit/shaders/cubes.glsl"
        if (none__(active_2)) continue;
#line 36 "tests/emit/shaders/cubes.glsl"
      }
#line 36 "tests/emit/shaders/cubes.glsl"
    }
#line 38 "tests/emit/shaders/cubes.glsl"
    sum = mixed(active, sum, texture(active, iChannel0, d));
    sum = mixed(active, sum, textureGrad(active, iChannel0, d, dFdx(d.zxy()) * 0.1f, dFdy(d)));
    set__(active, color, make<vec4>(shift_right(sum, Int(8))) * 5.9604645e-08f);
#line 40 "tests/emit/shaders/cubes.glsl"
  }
#line 123 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
