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

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  float iTime{};
  float iTimeDelta{};
  int iFrame{};
  uniform::vec4 iDate{};
  uniform::vec4 iMouse{};
  float iSampleRate{};
  array<uniform::vec3, 10> iChannelResolution{};
  float iFrameRate{};
  array<float, 4> iChannelTime{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/uniforms.glsl"
    set__(active, color, vec4(0.0f));
    Int k = make<Int>(p.x) % 4;
    set__(active, color, vec4(uniform::vec4(iResolution.x, iResolution.y, iResolution.z, iTime)));
    if (Bool active_2 = active && (k == 1); any__(active_2)) {
#line 5 "tests/emit/shaders/uniforms.glsl"
      set__(active_2, color, vec4(uniform::vec4(iTimeDelta, float(iFrame), iFrameRate, iSampleRate)));
#line 5 "tests/emit/shaders/uniforms.glsl"
    }
    if (Bool active_2 = active && (k == 2); any__(active_2)) {
#line 6 "tests/emit/shaders/uniforms.glsl"
      set__(active_2, color, vec4(iDate + iMouse));
#line 6 "tests/emit/shaders/uniforms.glsl"
    }
    if (Bool active_2 = active && (k == 3); any__(active_2)) {
#line 7 "tests/emit/shaders/uniforms.glsl"
      set__(active_2, color, vec4(iChannelResolution[0].xy(), iChannelTime[1], gl_FragCoord.z + gl_FragCoord.w));
#line 7 "tests/emit/shaders/uniforms.glsl"
    }
#line 7 "tests/emit/shaders/uniforms.glsl"
  }
#line 93 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
