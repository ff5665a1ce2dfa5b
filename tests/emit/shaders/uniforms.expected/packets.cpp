#include "reference/twin/packet_invocation.h"

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
  float iFrameRate{};
  array<float, 4> iChannelTime{};
  array<uniform::vec3, 10> iChannelResolution{};

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
    bind("iFrameRate", iFrameRate);
    bind("iChannelTime", iChannelTime);
    bind("iChannelResolution", iChannelResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/uniforms.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/uniforms.glsl"
    unwritten(active, color);
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
#line 64 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
