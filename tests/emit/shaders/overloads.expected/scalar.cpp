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
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 29;

#line 5 "tests/emit/shaders/overloads.glsl"
  Float g(Float x, int unused) {
#line 5 "tests/emit/shaders/overloads.glsl"
    return x + 1.0f;
#line 5 "tests/emit/shaders/overloads.glsl"
  }
#line 27 "twin.cpp"

#line 6 "tests/emit/shaders/overloads.glsl"
  Float f(uint u) {
#line 6 "tests/emit/shaders/overloads.glsl"
    return Float(u) + 0.125f;
#line 6 "tests/emit/shaders/overloads.glsl"
  }
#line 35 "twin.cpp"

#line 7 "tests/emit/shaders/overloads.glsl"
  Float f(int i) {
#line 7 "tests/emit/shaders/overloads.glsl"
    return Float(i) + 0.25f;
#line 7 "tests/emit/shaders/overloads.glsl"
  }
#line 43 "twin.cpp"

#line 8 "tests/emit/shaders/overloads.glsl"
  Float f(Float x) {
#line 8 "tests/emit/shaders/overloads.glsl"
    return x + 0.5f;
#line 8 "tests/emit/shaders/overloads.glsl"
  }
#line 51 "twin.cpp"

#line 9 "tests/emit/shaders/overloads.glsl"
  Float f(vec2 v) {
#line 9 "tests/emit/shaders/overloads.glsl"
    return f(v.x) + f(v.y);
#line 9 "tests/emit/shaders/overloads.glsl"
  }
#line 59 "twin.cpp"

#line 10 "tests/emit/shaders/overloads.glsl"
  Float f(vec2 v, Float w) {
#line 10 "tests/emit/shaders/overloads.glsl"
    return f(v) * w;
#line 10 "tests/emit/shaders/overloads.glsl"
  }
#line 67 "twin.cpp"

#line 11 "tests/emit/shaders/overloads.glsl"
  Float f(mat2 m) {
#line 11 "tests/emit/shaders/overloads.glsl"
    return m[0].x;
#line 11 "tests/emit/shaders/overloads.glsl"
  }
#line 75 "twin.cpp"

#line 12 "tests/emit/shaders/overloads.glsl"
  Float f(array<Float, 2> v) {
#line 12 "tests/emit/shaders/overloads.glsl"
    return v[0] - v[1];
#line 12 "tests/emit/shaders/overloads.glsl"
  }
#line 83 "twin.cpp"

#line 13 "tests/emit/shaders/overloads.glsl"
  bool f(bool b) {
#line 13 "tests/emit/shaders/overloads.glsl"
    return !b;
#line 13 "tests/emit/shaders/overloads.glsl"
  }
#line 91 "twin.cpp"

#line 14 "tests/emit/shaders/overloads.glsl"
  void nothing() {
#line 14 "tests/emit/shaders/overloads.glsl"
  }
#line 97 "twin.cpp"

#line 15 "tests/emit/shaders/overloads.glsl"
  vec4 zero() {
#line 15 "tests/emit/shaders/overloads.glsl"
    nothing();
#line 15 "tests/emit/shaders/overloads.glsl"
    return vec4(0.0f);
#line 15 "tests/emit/shaders/overloads.glsl"
  }
#line 107 "twin.cpp"

#line 16 "tests/emit/shaders/overloads.glsl"
  void mainImage(vec4& color, vec2 p) {
    color = zero() + vec4(f(p.x) + f(make<int>(p.x)), f(p, 2.0f), f(make<uint>(p.y)) + f(mat2(p.x)), g(p.y, 3) + f(array<Float, 2>{{p.x, p.y}}) + (f(p.x > 3.0f) ? 1.0f : 0.0f));
#line 17 "tests/emit/shaders/overloads.glsl"
  }
#line 114 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
