#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};
  sampler2D iChannel0{};
  sampler2D iChannel1{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iFrame", iFrame);
    bind("iChannel0", iChannel0);
    bind("iChannel1", iChannel1);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 18;

#line 4 "tests/emit/shaders/feedback.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 4 "tests/emit/shaders/feedback.glsl"
    unwritten(active, color);
    vec4 before = texelFetch(active, iChannel0, make<ivec2>(p), 0);
#line 5 "tests/emit/shaders/feedback.glsl"
    vec4 other = texelFetch(active, iChannel1, modulo(make<ivec2>(p.yx()), Int(8)), 0);
    if (Bool active_2 = active && (iFrame == 1 && p.x < 3.0f); any__(active_2)) {
#line 6 "tests/emit/shaders/feedback.glsl"
      alive__ = alive__ && !active_2;
#line 6 "tests/emit/shaders/feedback.glsl"
      mask_out__(active_2, active);
#line 6 "tests/emit/shaders/feedback.glsl"
    }
#line 6 "tests/emit/shaders/feedback.glsl"
    if (none__(active)) return;
    set__(active, color, before * 0.5f + other + float(iFrame));
#line 7 "tests/emit/shaders/feedback.glsl"
  }
#line 46 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    keep__(alive__, active);
    if (none__(active)) return;
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
