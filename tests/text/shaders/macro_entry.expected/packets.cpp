#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 10;

#line 3 "tests/text/shaders/macro_entry.glsl"
  void mainImage(Bool active, vec4& o, vec2 u) {
#line 3 "tests/text/shaders/macro_entry.glsl"
    set__(active, o, vec4(u, 0.0f, 1.0f));
#line 3 "tests/text/shaders/macro_entry.glsl"
  }
#line 27 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
