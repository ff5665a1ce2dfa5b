#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 29;

#line 5 "tests/emit/shaders/overloads.glsl"
  Float g(Bool active, Float x, int unused) {
#line 5 "tests/emit/shaders/overloads.glsl"
    return x + 1.0f;
#line 5 "tests/emit/shaders/overloads.glsl"
  }
#line 27 "twin.cpp"

#line 6 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, Uint u) {
#line 6 "tests/emit/shaders/overloads.glsl"
    return make<Float>(u) + 0.125f;
#line 6 "tests/emit/shaders/overloads.glsl"
  }
#line 35 "twin.cpp"

#line 7 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, Int i) {
#line 7 "tests/emit/shaders/overloads.glsl"
    return make<Float>(i) + 0.25f;
#line 7 "tests/emit/shaders/overloads.glsl"
  }
#line 43 "twin.cpp"

#line 8 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, Float x) {
#line 8 "tests/emit/shaders/overloads.glsl"
    return x + 0.5f;
#line 8 "tests/emit/shaders/overloads.glsl"
  }
#line 51 "twin.cpp"

#line 9 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, vec2 v) {
#line 9 "tests/emit/shaders/overloads.glsl"
    return f(active, v.x) + f(active, v.y);
#line 9 "tests/emit/shaders/overloads.glsl"
  }
#line 59 "twin.cpp"

#line 10 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, vec2 v, float w) {
#line 10 "tests/emit/shaders/overloads.glsl"
    return f(active, v) * w;
#line 10 "tests/emit/shaders/overloads.glsl"
  }
#line 67 "twin.cpp"

#line 11 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, mat2 m) {
#line 11 "tests/emit/shaders/overloads.glsl"
    return m[0].x;
#line 11 "tests/emit/shaders/overloads.glsl"
  }
#line 75 "twin.cpp"

#line 12 "tests/emit/shaders/overloads.glsl"
  Float f(Bool active, array<Float, 2> v) {
#line 12 "tests/emit/shaders/overloads.glsl"
    return v[0] - v[1];
#line 12 "tests/emit/shaders/overloads.glsl"
  }
#line 83 "twin.cpp"

#line 13 "tests/emit/shaders/overloads.glsl"
  Bool f(Bool active, Bool b) {
#line 13 "tests/emit/shaders/overloads.glsl"
    return !b;
#line 13 "tests/emit/shaders/overloads.glsl"
  }
#line 91 "twin.cpp"

#line 14 "tests/emit/shaders/overloads.glsl"
  void nothing(Bool active) {
#line 14 "tests/emit/shaders/overloads.glsl"
  }
#line 97 "twin.cpp"

#line 15 "tests/emit/shaders/overloads.glsl"
  uniform::vec4 zero(Bool active) {
#line 15 "tests/emit/shaders/overloads.glsl"
    nothing(active);
#line 15 "tests/emit/shaders/overloads.glsl"
    return uniform::vec4(0.0f);
#line 15 "tests/emit/shaders/overloads.glsl"
  }
#line 107 "twin.cpp"

#line 16 "tests/emit/shaders/overloads.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
    set__(active, color, vec4(zero(active)) + vec4(f(active, p.x) + f(active, make<Int>(p.x)), f(active, p, 2.0f), f(active, make<Uint>(p.y)) + f(active, make<mat2>(p.x)), g(active, p.y, 3) + f(active, array<Float, 2>{{p.x, p.y}}) + select__(f(active, p.x > 3.0f), Float(1.0f), Float(0.0f))));
#line 17 "tests/emit/shaders/overloads.glsl"
  }
#line 114 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
