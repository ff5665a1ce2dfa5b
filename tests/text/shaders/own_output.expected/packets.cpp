#include "reference/twin/packet_invocation.h"
#undef color
#undef iChannel0
#undef iChannel1
#undef iChannel2
#undef iChannel3
#undef iChannel4
#undef iChannel5
#undef iChannel6
#undef iChannel7
#undef iChannel8
#undef iChannel9
#undef iChannelResolution
#undef iDate
#undef iFrame
#undef iKeyboard
#undef iMouse
#undef iMouseButton
#undef iResolution
#undef iSampleRate
#undef iTime
#undef iTimeDelta
#undef iViewMatrix
#undef main

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

#line 3 "tests/text/shaders/own_output.glsl"
  void main(Bool active) {
#line 3 "tests/text/shaders/own_output.glsl"
    set__(active, color, vec4(gl_FragCoord.xy() / vec2(iResolution.xy()), 0.0f, 1.0f));
#line 3 "tests/text/shaders/own_output.glsl"
  }
#line 51 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(color)
