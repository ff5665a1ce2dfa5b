#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  array<vec3, 10> iChannelResolution{};
  sampler2D iChannel0{};

  void initialise__() {
    unwritten(shadertoy_out_color);
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
  vec4 look(sampler2D s, vec2 uv) {
#line 6 "tests/emit/shaders/texture_functions.glsl"
    return texture(s, uv) + texelFetch(s, make<ivec2>(uv * 3.0f), 0);
#line 6 "tests/emit/shaders/texture_functions.glsl"
  }
#line 33 "twin.cpp"

#line 7 "tests/emit/shaders/texture_functions.glsl"
  Float size(sampler2D s, int i) {
#line 7 "tests/emit/shaders/texture_functions.glsl"
    return Float(at(textureSize(s, 0), i));
#line 7 "tests/emit/shaders/texture_functions.glsl"
  }
#line 41 "twin.cpp"

#line 8 "tests/emit/shaders/texture_functions.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/texture_functions.glsl"
    unwritten(color);
    vec2 uv = p / iResolution.xy();
    int k = make<int>(p.y) % 8;
    color = vec4(size(iChannel0, 0), size(iChannel0, 1), iChannelResolution[0].xy());
    if (k == 0) {
#line 12 "tests/emit/shaders/texture_functions.glsl"
      color = look(iChannel0, uv * 2.0f + 0.01f);
#line 12 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 1) {
#line 13 "tests/emit/shaders/texture_functions.glsl"
      color = textureLod(iChannel0, -uv, 0.0f);
#line 13 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 2) {
#line 14 "tests/emit/shaders/texture_functions.glsl"
      color = textureGrad(iChannel0, uv.yx(), vec2(0.01f), vec2(0.0f));
#line 14 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 3) {
#line 15 "tests/emit/shaders/texture_functions.glsl"
      color = textureOffset(iChannel0, uv, ivec2(1, -2)) + texelFetchOffset(iChannel0, make<ivec2>(p), 0, ivec2(-1, 1));
#line 15 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 4) {
#line 16 "tests/emit/shaders/texture_functions.glsl"
      color = textureProj(iChannel0, vec3(p, 20.0f)) + textureProj(iChannel0, vec4(p, 1.0f, 16.0f));
#line 16 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 5) {
#line 17 "tests/emit/shaders/texture_functions.glsl"
      color = texture(iChannel0, uv, 1.0f) + textureLodOffset(iChannel0, uv, 0.0f, ivec2(2));
#line 17 "tests/emit/shaders/texture_functions.glsl"
    }
    if (k == 6) {
#line 18 "tests/emit/shaders/texture_functions.glsl"
      color = textureProjLod(iChannel0, vec3(p, 8.0f), 0.0f) + textureGradOffset(iChannel0, uv, vec2(0.0f), vec2(0.0f), ivec2(-1));
#line 18 "tests/emit/shaders/texture_functions.glsl"
    }
#line 18 "tests/emit/shaders/texture_functions.glsl"
  }
#line 87 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
