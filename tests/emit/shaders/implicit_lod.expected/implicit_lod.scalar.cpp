#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  sampler2D iChannel0{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 12;

#line 5 "tests/emit/shaders/implicit_lod.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 5 "tests/emit/shaders/implicit_lod.glsl"
    unwritten(color);
    vec2 uv = p / iResolution.xy();
    color = texture(iChannel0, uv * 3.7f);
    if (p.x > 8.0f) {
#line 8 "tests/emit/shaders/implicit_lod.glsl"
      color += texture(iChannel0, uv * uv.x * 5.0f, 0.5f);
#line 8 "tests/emit/shaders/implicit_lod.glsl"
    }
    color += textureLod(iChannel0, uv, 1.5f) + textureGrad(iChannel0, uv, vec2(0.2f, 0.0f), vec2(0.0f, 0.1f));
#line 9 "tests/emit/shaders/implicit_lod.glsl"
  }
#line 39 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
