#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float iTimeOffset{};
  int iSampleOffset{};
  Float iSampleRate{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iTimeOffset", iTimeOffset);
    bind("iSampleOffset", iSampleOffset);
    bind("iSampleRate", iSampleRate);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 6;

  void main() {
    int shadertwin_sample = make<int>(gl_FragCoord.x) + 512 * make<int>(gl_FragCoord.y);
    Float shadertwin_time = iTimeOffset + Float(shadertwin_sample) / iSampleRate;
    shadertoy_out_color = vec4(mainSound(iSampleOffset + shadertwin_sample, shadertwin_time), 0.0f, 1.0f);
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  Float wave(Float t, Float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 39 "twin.cpp"

#line 1 "tests/text/shaders/passes/sound.glsl"
  vec2 mainSound(int samp, Float time) {
#line 1 "tests/text/shaders/passes/sound.glsl"
    return vec2(wave(time, 440.0f), wave(time, 441.0f));
#line 1 "tests/text/shaders/passes/sound.glsl"
  }
#line 47 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
