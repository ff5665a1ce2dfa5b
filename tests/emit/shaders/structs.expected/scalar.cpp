#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Padded {
  uint a;
  mat4 m;
  array<Float, 4> b;
  bvec4 c;
  bool operator==(const Padded&) const = default;
};

struct Inner {
  vec2 a;
  array<Float, 2> b;
  bool operator==(const Inner&) const = default;
};

struct Outer {
  Inner inner;
  mat2 m;
  int n;
  bool flag;
  bool operator==(const Outer&) const = default;
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  Padded padded{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    padded = Padded{31u, mat4(10.0f, -1.5f, 7.5f, 1.0f, -1.5f, 0.5f, 10.0f, 7.5f, 1.0f, 1.0f, 1.0f, 2.0f, -1.5f, 2.0f, -1.5f, 1.0f), array<Float, 4>{{2.0f, 1.0f, 3.0f, 2.0f}}, bvec4(true)};
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 155;

#line 4 "tests/emit/shaders/structs.glsl"
  Outer make_outer(Float x) {
#line 4 "tests/emit/shaders/structs.glsl"
    return Outer{Inner{vec2(x, 2.0f * x), array<Float, 2>{{x * 5.0f, x * 3.0f}}}, mat2(x, 0.0f, 0.0f, x), make<int>(x * 10.0f), x > 0.5f};
#line 4 "tests/emit/shaders/structs.glsl"
  }
#line 53 "twin.cpp"

#line 5 "tests/emit/shaders/structs.glsl"
  void change(Outer& o, Inner from) {
#line 5 "tests/emit/shaders/structs.glsl"
    o.inner = from;
#line 5 "tests/emit/shaders/structs.glsl"
    o.inner.b[1] += 1.0f;
#line 5 "tests/emit/shaders/structs.glsl"
    o.n++;
#line 5 "tests/emit/shaders/structs.glsl"
  }
#line 65 "twin.cpp"

#line 6 "tests/emit/shaders/structs.glsl"
  Inner swapped(Inner i) {
#line 6 "tests/emit/shaders/structs.glsl"
    i.a = i.a.yx();
#line 6 "tests/emit/shaders/structs.glsl"
    Float t = i.b[0];
#line 6 "tests/emit/shaders/structs.glsl"
    i.b[0] = i.b[1];
#line 6 "tests/emit/shaders/structs.glsl"
    i.b[1] = t;
#line 6 "tests/emit/shaders/structs.glsl"
    return i;
#line 6 "tests/emit/shaders/structs.glsl"
  }
#line 81 "twin.cpp"

#line 9 "tests/emit/shaders/structs.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 9 "tests/emit/shaders/structs.glsl"
    unwritten(color);
    Outer o = make_outer(p.x / iResolution.x);
    Outer copy = o;
    change(copy, swapped(o.inner));
#line 14 "tests/emit/shaders/structs.glsl"
    array<Outer, 3> list;
#line 14 "tests/emit/shaders/structs.glsl"
    list[0] = o;
#line 14 "tests/emit/shaders/structs.glsl"
    list[1] = copy;
#line 14 "tests/emit/shaders/structs.glsl"
    list[2] = o;
    list[2].inner.a.x = 7.0f;
    bool same = o == list[0];
#line 16 "tests/emit/shaders/structs.glsl"
    bool different = o != copy;
    Inner empty = Inner{vec2(0.0f), array<Float, 2>{{0.0f, 0.0f}}};
    color = vec4(copy.inner.a.x + list[2].inner.a.x, copy.inner.b[1], Float(copy.n) + (same ? 0.25f : 0.0f), (different ? 1.0f : 0.0f) + (empty == o.inner ? 2.0f : 0.0f) + list[1].m[1].y);
#line 20 "tests/emit/shaders/structs.glsl"
    if (p.y > 6.0f) {
#line 20 "tests/emit/shaders/structs.glsl"
      color.x = padded.m[1].x;
#line 20 "tests/emit/shaders/structs.glsl"
    }
#line 20 "tests/emit/shaders/structs.glsl"
  }
#line 112 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
