#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  float iTime{};
  sampler2D iChannel0{};
  vec2 unused{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, unused);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iTime", iTime);
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 2;

#line 4 "tests/text/shaders/legacy_names.glsl"
  Float level(Bool active) {
#line 4 "tests/text/shaders/legacy_names.glsl"
    return texture(active, iChannel0, gl_FragCoord.xy() / vec2(iResolution.xy())).x + iTime;
#line 4 "tests/text/shaders/legacy_names.glsl"
  }
#line 35 "twin.cpp"

#line 5 "tests/text/shaders/legacy_names.glsl"
  void main(Bool active) {
#line 5 "tests/text/shaders/legacy_names.glsl"
    set__(active, shadertoy_out_color, vec4(clamp(level(active), Float(0.0f), Float(1.0f))));
#line 5 "tests/text/shaders/legacy_names.glsl"
  }
#line 43 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
