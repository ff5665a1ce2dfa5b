#include "reference/twin/invocation.h"
#undef check
#undef color
#undef i
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

#line 2 "tests/emit/shaders/discards.glsl"
  Float check(vec2 p) {
#line 2 "tests/emit/shaders/discards.glsl"
    if (p.x > 10.0f) {
#line 2 "tests/emit/shaders/discards.glsl"
      stop_invocation__();
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    for (int i = 0;; i++) {
#line 2 "tests/emit/shaders/discards.glsl"
      if (Float(i) > p.y) {
#line 2 "tests/emit/shaders/discards.glsl"
        break;
#line 2 "tests/emit/shaders/discards.glsl"
      }
#line 2 "tests/emit/shaders/discards.glsl"
      if (i == 6) {
#line 2 "tests/emit/shaders/discards.glsl"
        stop_invocation__();
#line 2 "tests/emit/shaders/discards.glsl"
      }
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    return p.x;
#line 2 "tests/emit/shaders/discards.glsl"
  }
#line 77 "twin.cpp"

#line 3 "tests/emit/shaders/discards.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 3 "tests/emit/shaders/discards.glsl"
    color = vec4(0.0f);
    if (mod(p.x, 4.0f) < 1.0f && p.y < 4.0f) {
#line 4 "tests/emit/shaders/discards.glsl"
      stop_invocation__();
#line 4 "tests/emit/shaders/discards.glsl"
    }
    color = vec4(check(p), p.y, 1.0f, 1.0f);
#line 5 "tests/emit/shaders/discards.glsl"
  }
#line 91 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
