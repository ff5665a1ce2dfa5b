#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  float iTimeOffset{};
  int iSampleOffset{};
  float iSampleRate{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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

  void main(Bool active) {
    Int shadertwin_sample = make<Int>(gl_FragCoord.x) + 512 * make<Int>(gl_FragCoord.y);
    Float shadertwin_time = iTimeOffset + make<Float>(shadertwin_sample) / iSampleRate;
    set__(active, shadertoy_out_color, vec4(mainSound(active, iSampleOffset + shadertwin_sample, shadertwin_time), 0.0f, 1.0f));
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  Float wave(Bool active, Float t, float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 39 "twin.cpp"

#line 1 "tests/text/shaders/passes/sound.glsl"
  vec2 mainSound(Bool active, Int samp, Float time) {
#line 1 "tests/text/shaders/passes/sound.glsl"
    return vec2(wave(active, time, 440.0f), wave(active, time, 441.0f));
#line 1 "tests/text/shaders/passes/sound.glsl"
  }
#line 47 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
