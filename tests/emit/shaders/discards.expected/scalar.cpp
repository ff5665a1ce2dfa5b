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
  static constexpr std::size_t components__ = 13;

#line 2 "tests/emit/shaders/discards.glsl"
  Float check(vec2 p) {
#line 2 "tests/emit/shaders/discards.glsl"
    if (p.x > 10.0f) {
#line 2 "tests/emit/shaders/discards.glsl"
      stop_invocation__();
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    for (int i = 0;; i++) {
#line 2 "tests/emit/shaders/discards.glsl"
      if (Float(i) > p.y) {
#line 2 "tests/emit/shaders/discards.glsl"
        break;
#line 2 "tests/emit/shaders/discards.glsl"
      }
#line 2 "tests/emit/shaders/discards.glsl"
      if (i == 6) {
#line 2 "tests/emit/shaders/discards.glsl"
        stop_invocation__();
#line 2 "tests/emit/shaders/discards.glsl"
      }
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    return p.x;
#line 2 "tests/emit/shaders/discards.glsl"
  }
#line 49 "twin.cpp"

#line 3 "tests/emit/shaders/discards.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 3 "tests/emit/shaders/discards.glsl"
    unwritten(color);
    if (mod(p.x, 4.0f) < 1.0f && p.y < 4.0f) {
#line 4 "tests/emit/shaders/discards.glsl"
      stop_invocation__();
#line 4 "tests/emit/shaders/discards.glsl"
    }
    color = vec4(check(p), p.y, 1.0f, 1.0f);
#line 5 "tests/emit/shaders/discards.glsl"
  }
#line 63 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
