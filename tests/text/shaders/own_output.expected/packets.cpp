#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  uniform::vec3 iResolution{};
  vec4 color{};

  void initialise__(Bool active) {
    unwritten(active, color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 0;

#line 3 "tests/text/shaders/own_output.glsl"
  void main(Bool active) {
#line 3 "tests/text/shaders/own_output.glsl"
    set__(active, color, vec4(gl_FragCoord.xy() / vec2(iResolution.xy()), 0.0f, 1.0f));
#line 3 "tests/text/shaders/own_output.glsl"
  }
#line 29 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(color)
