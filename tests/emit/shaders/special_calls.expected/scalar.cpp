#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 14;

#line 2 "tests/emit/shaders/special_calls.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/special_calls.glsl"
    unwritten(color);
    vec2 uv = p / iResolution.yx();
    Float x = sqrt(p.x / 7.0f) - p.y / iResolution.x;
#line 4 "tests/emit/shaders/special_calls.glsl"
    Float y = p.y / iResolution.y;
    color = vec4(mix_strict(x, y, 0.3f), mix_strict(x, 1.0f, y), mix_strict(vec2(x, y), uv, 0.7f).y, mix(uv, vec2(y, x), x).x);
    if (p.y > 3.0f) {
#line 6 "tests/emit/shaders/special_calls.glsl"
      const Float tmp = y + x;
#line 6 "tests/emit/shaders/special_calls.glsl"
      color = vec4(y * y, (tmp * tmp) * (tmp * tmp), exp2(x), (uv * uv).y);
#line 6 "tests/emit/shaders/special_calls.glsl"
    }
    if (p.y > 6.0f) {
#line 7 "tests/emit/shaders/special_calls.glsl"
      color = vec4(min(-x * 0.0f, 0.0f), max(uv, vec2(0.5f)).x, y, pow(abs(x), 1.3f));
#line 7 "tests/emit/shaders/special_calls.glsl"
    }
#line 7 "tests/emit/shaders/special_calls.glsl"
  }
#line 46 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
