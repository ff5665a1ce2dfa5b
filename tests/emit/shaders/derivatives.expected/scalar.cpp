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
  static constexpr bool uses_derivatives__ = true;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 21;

#line 2 "tests/emit/shaders/derivatives.glsl"
  Float grid(vec2 p) {
#line 2 "tests/emit/shaders/derivatives.glsl"
    vec2 w = fwidth(p);
#line 2 "tests/emit/shaders/derivatives.glsl"
    return w.x + w.y;
#line 2 "tests/emit/shaders/derivatives.glsl"
  }
#line 29 "twin.cpp"

#line 3 "tests/emit/shaders/derivatives.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 3 "tests/emit/shaders/derivatives.glsl"
    unwritten(color);
    Float f = p.x * p.x + p.y * 3.0f;
    vec2 uv = p * vec2(0.5f, 2.0f);
    if (p.x > 5.0f) {
#line 6 "tests/emit/shaders/derivatives.glsl"
      f += 10.0f;
#line 6 "tests/emit/shaders/derivatives.glsl"
    }
    vec3 v = dFdx(vec3(f, uv));
    color = vec4(v.x + v.z, dFdy(f), grid(uv * uv), fwidth(f) + dFdy(uv).y);
    for (int i = 0; i < 3; i++) {
#line 9 "tests/emit/shaders/derivatives.glsl"
      f *= 2.0f;
#line 9 "tests/emit/shaders/derivatives.glsl"
      color.x += dFdx(f);
#line 9 "tests/emit/shaders/derivatives.glsl"
    }
#line 9 "tests/emit/shaders/derivatives.glsl"
  }
#line 53 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
