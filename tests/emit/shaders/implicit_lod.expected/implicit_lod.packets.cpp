#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  sampler2D iChannel0{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 5 "tests/emit/shaders/implicit_lod.glsl"
    unwritten(active, color);
    vec2 uv = p / vec2(iResolution.xy());
    set__(active, color, texture(active, iChannel0, uv * 3.7f));
    if (Bool active_2 = active && (p.x > 8.0f); any__(active_2)) {
#line 8 "tests/emit/shaders/implicit_lod.glsl"
      set__(active_2, color, color + texture(active_2, iChannel0, uv * uv.x * 5.0f, 0.5f));
#line 8 "tests/emit/shaders/implicit_lod.glsl"
    }
    set__(active, color, color + (textureLod(active, iChannel0, uv, 1.5f) + textureGrad(active, iChannel0, uv, uniform::vec2(0.2f, 0.0f), uniform::vec2(0.0f, 0.1f))));
#line 9 "tests/emit/shaders/implicit_lod.glsl"
  }
#line 39 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
