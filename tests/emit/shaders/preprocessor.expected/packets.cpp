#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

const float THIRD = 2.0943952f;

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  float iTime{};
  Float time_scale{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    time_scale = 2.0f;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iTime", iTime);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 19;

#line 26 "tests/emit/shaders/preprocessor.glsl"
  void mainImage(Bool active, vec4& O, vec2 U) {
#line 26 "tests/emit/shaders/preprocessor.glsl"
    unwritten(active, O);
    float acc = 0.0f;
    for (int i = 0; i < 4; i++) {
#line 28 "tests/emit/shaders/preprocessor.glsl"
      acc += float(i) * float(i) * 2.0f;
#line 28 "tests/emit/shaders/preprocessor.glsl"
    }
    uniform::vec2 R = iResolution.xy();
#line 29 "tests/emit/shaders/preprocessor.glsl"
    vec2 uv = (U + U - vec2(R)) / R.y * make<mat2>(uniform::mat2(0.75f, -0.25f, 0.25f, 0.75f));
    set__(active, O, vec4(acc + 0.5f, uv, THIRD * time_scale + (iTime + 0.25f)));
#line 30 "tests/emit/shaders/preprocessor.glsl"
  }
#line 45 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
