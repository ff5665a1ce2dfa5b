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
#undef mainImage
#undef p
#undef shadertoy_color
#undef shadertoy_out_color
#undef sum

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = true;

#line 2 "tests/emit/shaders/endless_discards.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/endless_discards.glsl"
    color = vec4(0.0f);
    Float sum = 1.0f / (1.0f + p.x);
    if (p.x + p.y > 20.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
      while (sum >= 0.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
        if (p.x > 1.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
          stop_invocation__();
#line 4 "tests/emit/shaders/endless_discards.glsl"
        }
#line 4 "tests/emit/shaders/endless_discards.glsl"
      }
#line 4 "tests/emit/shaders/endless_discards.glsl"
    }
    color = vec4(p, sum, 1.0f);
#line 5 "tests/emit/shaders/endless_discards.glsl"
  }
#line 69 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
