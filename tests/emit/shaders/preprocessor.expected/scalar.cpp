#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

const Float THIRD = 2.0943952f;

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  Float iTime{};
  Float time_scale{};

  void initialise__() {
    unwritten(shadertoy_out_color);
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
  void mainImage(vec4& O, vec2 U) {
#line 26 "tests/emit/shaders/preprocessor.glsl"
    unwritten(O);
    Float acc = 0.0f;
    for (int i = 0; i < 4; i++) {
#line 28 "tests/emit/shaders/preprocessor.glsl"
      acc += Float(i) * Float(i) * 2.0f;
#line 28 "tests/emit/shaders/preprocessor.glsl"
    }
    vec2 R = iResolution.xy();
#line 29 "tests/emit/shaders/preprocessor.glsl"
    vec2 uv = (U + U - R) / R.y * mat2(0.75f, -0.25f, 0.25f, 0.75f);
    O = vec4(acc + 0.5f, uv, THIRD * time_scale + (iTime + 0.25f));
#line 30 "tests/emit/shaders/preprocessor.glsl"
  }
#line 45 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
