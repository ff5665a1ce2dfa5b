#include "reference/twin/invocation.h"
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

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec3 iResolution{};
  vec4 color{};

  void initialise__() {
    unwritten(color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;

#line 3 "tests/text/shaders/own_output.glsl"
  void main() {
#line 3 "tests/text/shaders/own_output.glsl"
    color = vec4(gl_FragCoord.xy() / iResolution.xy(), 0.0f, 1.0f);
#line 3 "tests/text/shaders/own_output.glsl"
  }
#line 51 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(color)
