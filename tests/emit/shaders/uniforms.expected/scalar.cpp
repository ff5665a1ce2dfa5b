#include "reference/twin/invocation.h"

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
  Float iFrameRate{};
  array<Float, 4> iChannelTime{};
  array<vec3, 10> iChannelResolution{};

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
    bind("iFrameRate", iFrameRate);
    bind("iChannelTime", iChannelTime);
    bind("iChannelResolution", iChannelResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/uniforms.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/uniforms.glsl"
    unwritten(color);
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
#line 64 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
