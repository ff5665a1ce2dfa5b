#include "reference/twin/invocation.h"

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
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/endless_discards.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/endless_discards.glsl"
    unwritten(color);
    Float sum = 1.0f / (1.0f + p.x);
    if (p.x + p.y > 20.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
      while (sum >= 0.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
        if (p.x > 1.0f) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
          stop_invocation__();
#line 4 "tests/emit/shaders/endless_discards.glsl"
        }
#line 4 "tests/emit/shaders/endless_discards.glsl"
      }
#line 4 "tests/emit/shaders/endless_discards.glsl"
    }
    color = vec4(p, sum, 1.0f);
#line 5 "tests/emit/shaders/endless_discards.glsl"
  }
#line 42 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
