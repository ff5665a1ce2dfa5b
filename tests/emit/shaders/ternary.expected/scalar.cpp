#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int calls{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    calls = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 25;

#line 3 "tests/emit/shaders/ternary.glsl"
  bool tick(bool b) {
#line 3 "tests/emit/shaders/ternary.glsl"
    calls++;
#line 3 "tests/emit/shaders/ternary.glsl"
    return b;
#line 3 "tests/emit/shaders/ternary.glsl"
  }
#line 31 "twin.cpp"

#line 4 "tests/emit/shaders/ternary.glsl"
  Float bump(Float& x) {
#line 4 "tests/emit/shaders/ternary.glsl"
    x += 1.0f;
#line 4 "tests/emit/shaders/ternary.glsl"
    return x;
#line 4 "tests/emit/shaders/ternary.glsl"
  }
#line 41 "twin.cpp"

#line 5 "tests/emit/shaders/ternary.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 5 "tests/emit/shaders/ternary.glsl"
    unwritten(color);
    Float x = p.x;
#line 6 "tests/emit/shaders/ternary.glsl"
    Float y = p.y;
    bool a = tick(x > 3.0f) && tick(y > 3.0f);
#line 7 "tests/emit/shaders/ternary.glsl"
    bool b = tick(x > 5.0f) || tick(y > 5.0f);
#line 7 "tests/emit/shaders/ternary.glsl"
    const bool tmp = tick(a);
#line 7 "tests/emit/shaders/ternary.glsl"
    bool c = tmp != tick(b);
    Float r = x > y ? bump(x) : bump(y);
    Float z = x > 4.0f ? y > 2.0f ? 1.0f : 2.0f : 3.0f;
    Float w = (x = y + 1.0f) * 2.0f;
    int i = 0;
#line 11 "tests/emit/shaders/ternary.glsl"
    i += i = 3;
    Float s = a ? bump(x) + bump(y) : b && c ? -1.0f : bump(x) * 0.5f;
    vec2 v = vec2(1.0f);
#line 13 "tests/emit/shaders/ternary.glsl"
    swizzle<1, 0>(v) = v *= 2.0f;
    if (!(a || b) && c == false) {
#line 14 "tests/emit/shaders/ternary.glsl"
      s += 0.5f;
#line 14 "tests/emit/shaders/ternary.glsl"
    }
    color = vec4(r + z * 8.0f, w + Float(calls) * 32.0f, s + Float(i), v.x + v.y + x - y);
#line 15 "tests/emit/shaders/ternary.glsl"
  }
#line 75 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
