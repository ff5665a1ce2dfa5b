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
#undef iChannelTime
#undef iDate
#undef iFrame
#undef iFrameRate
#undef iKeyboard
#undef iMouse
#undef iMouseButton
#undef iResolution
#undef iSampleRate
#undef iTime
#undef iTimeDelta
#undef iViewMatrix
#undef k
#undef main
#undef mainImage
#undef p
#undef shadertoy_color
#undef shadertoy_out_color

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  Float iTime{};
  Float iTimeDelta{};
  int iFrame{};
  vec4 iDate{};
  vec4 iMouse{};
  Float iSampleRate{};
  array<vec3, 10> iChannelResolution{};
  Float iFrameRate{};
  array<Float, 4> iChannelTime{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iTime", iTime);
    bind("iTimeDelta", iTimeDelta);
    bind("iFrame", iFrame);
    bind("iDate", iDate);
    bind("iMouse", iMouse);
    bind("iSampleRate", iSampleRate);
    bind("iChannelResolution", iChannelResolution);
    bind("iFrameRate", iFrameRate);
    bind("iChannelTime", iChannelTime);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;

#line 2 "tests/emit/shaders/uniforms.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/uniforms.glsl"
    color = vec4(0.0f);
    int k = make<int>(p.x) % 4;
    color = vec4(iResolution.x, iResolution.y, iResolution.z, iTime);
    if (k == 1) {
#line 5 "tests/emit/shaders/uniforms.glsl"
      color = vec4(iTimeDelta, Float(iFrame), iFrameRate, iSampleRate);
#line 5 "tests/emit/shaders/uniforms.glsl"
    }
    if (k == 2) {
#line 6 "tests/emit/shaders/uniforms.glsl"
      color = iDate + iMouse;
#line 6 "tests/emit/shaders/uniforms.glsl"
    }
    if (k == 3) {
#line 7 "tests/emit/shaders/uniforms.glsl"
      color = vec4(iChannelResolution[0].xy(), iChannelTime[1], gl_FragCoord.z + gl_FragCoord.w);
#line 7 "tests/emit/shaders/uniforms.glsl"
    }
#line 7 "tests/emit/shaders/uniforms.glsl"
  }
#line 93 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
