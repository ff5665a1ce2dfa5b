#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  array<uniform::vec3, 10> iChannelResolution{};
  sampler2D iChannel0{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iChannelResolution", iChannelResolution);
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 18;

#line 6 "tests/emit/shaders/texture_functions.glsl"
  vec4 look(Bool active, sampler2D s, vec2 uv) {
#line 6 "tests/emit/shaders/texture_functions.glsl"
    return texture(active, s, uv) + texelFetch(active, s, make<ivec2>(uv * 3.0f), 0);
#line 6 "tests/emit/shaders/texture_functions.glsl"
  }
#line 33 "twin.cpp"

#line 7 "tests/emit/shaders/texture_functions.glsl"
  float size(Bool active, sampler2D s, int i) {
#line 7 "tests/emit/shaders/texture_functions.glsl"
    return float(at(glsl::textureSize(s, 0), i));
#line 7 "tests/emit/shaders/texture_functions.glsl"
  }
#line 41 "twin.cpp"

#line 8 "tests/emit/shaders/texture_functions.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/texture_functions.glsl"
    unwritten(active, color);
    vec2 uv = p / vec2(iResolution.xy());
    Int k = make<Int>(p.y) % 8;
    set__(active, color, vec4(uniform::vec4(size(active, iChannel0, 0), size(active, iChannel0, 1), iChannelResolution[0].xy())));
    if (Bool active_2 = active && (k == 0); any__(active_2)) {
#line 12 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, look(active_2, iChannel0, uv * 2.0f + 0.01f));
#line 12 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 1); any__(active_2)) {
#line 13 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, textureLod(active_2, iChannel0, -uv, 0.0f));
#line 13 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 2); any__(active_2)) {
#line 14 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, textureGrad(active_2, iChannel0, uv.yx(), uniform::vec2(0.01f), uniform::vec2(0.0f)));
#line 14 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 3); any__(active_2)) {
#line 15 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, textureOffset(active_2, iChannel0, uv, uniform::ivec2(1, -2)) + texelFetchOffset(active_2, iChannel0, make<ivec2>(p), 0, uniform::ivec2(-1, 1)));
#line 15 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 4); any__(active_2)) {
#line 16 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, textureProj(active_2, iChannel0, vec3(p, 20.0f)) + textureProj(active_2, iChannel0, vec4(p, 1.0f, 16.0f)));
#line 16 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 5); any__(active_2)) {
#line 17 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, texture(active_2, iChannel0, uv, 1.0f) + textureLodOffset(active_2, iChannel0, uv, 0.0f, uniform::ivec2(2)));
#line 17 "tests/emit/shaders/texture_functions.glsl"
    }
    if (Bool active_2 = active && (k == 6); any__(active_2)) {
#line 18 "tests/emit/shaders/texture_functions.glsl"
      set__(active_2, color, textureProjLod(active_2, iChannel0, vec3(p, 8.0f), 0.0f) + textureGradOffset(active_2, iChannel0, uv, uniform::vec2(0.0f), uniform::vec2(0.0f), uniform::ivec2(-1)));
#line 18 "tests/emit/shaders/texture_functions.glsl"
    }
#line 18 "tests/emit/shaders/texture_functions.glsl"
  }
#line 87 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
