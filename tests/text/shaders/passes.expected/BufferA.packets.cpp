#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  float iTime{};
  sampler2D iChannel0{};
  samplerCube iChannel1{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iTime", iTime);
    bind("iChannel0", iChannel0);
    bind("iChannel1", iChannel1);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 12;

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  float wave(Bool active, float t, float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 39 "twin.cpp"

#line 3 "tests/text/shaders/passes/buffer_a.glsl"
  void mainImage(Bool active, vec4& c, vec2 p) {
    set__(active, c, texelFetch(active, iChannel0, make<ivec2>(p), 0) + texture(active, iChannel1, vec3(p, 1.0f)) * wave(active, iTime, 1.0f));
#line 4 "tests/text/shaders/passes/buffer_a.glsl"
  }
#line 46 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
