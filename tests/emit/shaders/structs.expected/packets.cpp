#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Padded {
  Uint a;
  mat4 m;
  array<Float, 4> b;
  bvec4 c;
  friend void set__(Bool m, Padded& to, const Padded& from) { set__(m, to.a, from.a); set__(m, to.m, from.m); set__(m, to.b, from.b); set__(m, to.c, from.c); }
  friend Bool same__(const Padded& a, const Padded& b) { return Bool(true) && same__(a.a, b.a) && same__(a.m, b.m) && same__(a.b, b.b) && same__(a.c, b.c); }
};

struct Inner {
  vec2 a;
  array<Float, 2> b;
  friend void set__(Bool m, Inner& to, const Inner& from) { set__(m, to.a, from.a); set__(m, to.b, from.b); }
  friend Bool same__(const Inner& a, const Inner& b) { return Bool(true) && same__(a.a, b.a) && same__(a.b, b.b); }
};

struct Outer {
  Inner inner;
  mat2 m;
  Int n;
  Bool flag;
  friend void set__(Bool m, Outer& to, const Outer& from) { set__(m, to.inner, from.inner); set__(m, to.m, from.m); set__(m, to.n, from.n); set__(m, to.flag, from.flag); }
  friend Bool same__(const Outer& a, const Outer& b) { return Bool(true) && same__(a.inner, b.inner) && same__(a.m, b.m) && same__(a.n, b.n) && same__(a.flag, b.flag); }
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  Padded padded{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    padded = Padded{31u, make<mat4>(10.0f, -1.5f, 7.5f, 1.0f, -1.5f, 0.5f, 10.0f, 7.5f, 1.0f, 1.0f, 1.0f, 2.0f, -1.5f, 2.0f, -1.5f, 1.0f), array<Float, 4>{{2.0f, 1.0f, 3.0f, 2.0f}}, bvec4(true)};
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
  Outer make_outer(Bool active, Float x) {
#line 4 "tests/emit/shaders/structs.glsl"
    return Outer{Inner{vec2(x, 2.0f * x), array<Float, 2>{{x * 5.0f, x * 3.0f}}}, make<mat2>(x, 0.0f, 0.0f, x), make<Int>(x * 10.0f), x > 0.5f};
#line 4 "tests/emit/shaders/structs.glsl"
  }
#line 56 "twin.cpp"

#line 5 "tests/emit/shaders/structs.glsl"
  void change(Bool active, Outer& o, Inner from) {
#line 5 "tests/emit/shaders/structs.glsl"
    set__(active, o.inner, from);
#line 5 "tests/emit/shaders/structs.glsl"
    set__(active, o.inner.b[1], o.inner.b[1] + 1.0f);
#line 5 "tests/emit/shaders/structs.glsl"
    set__(active, o.n, o.n + 1);
#line 5 "tests/emit/shaders/structs.glsl"
  }
#line 68 "twin.cpp"

#line 6 "tests/emit/shaders/structs.glsl"
  Inner swapped(Bool active, Inner i) {
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
#line 84 "twin.cpp"

#line 9 "tests/emit/shaders/structs.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 9 "tests/emit/shaders/structs.glsl"
    unwritten(active, color);
    Outer o = make_outer(active, p.x / iResolution.x);
    Outer copy = o;
    change(active, copy, swapped(active, o.inner));
#line 14 "tests/emit/shaders/structs.glsl"
    array<Outer, 3> list;
#line 14 "tests/emit/shaders/structs.glsl"
    list[0] = o;
#line 14 "tests/emit/shaders/structs.glsl"
    list[1] = copy;
#line 14 "tests/emit/shaders/structs.glsl"
    list[2] = o;
    list[2].inner.a.x = 7.0f;
    Bool same = same__(o, list[0]);
#line 16 "tests/emit/shaders/structs.glsl"
    Bool different = !same__(o, copy);
    Inner empty = Inner{vec2(0.0f), array<Float, 2>{{0.0f, 0.0f}}};
    set__(active, color, vec4(copy.inner.a.x + list[2].inner.a.x, copy.inner.b[1], make<Float>(copy.n) + select__(same, Float(0.25f), Float(0.0f)), select__(different, Float(1.0f), Float(0.0f)) + select__(same__(empty, o.inner), Float(2.0f), Float(0.0f)) + list[1].m[1].y));
#line 20 "tests/emit/shaders/structs.glsl"
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 20 "tests/emit/shaders/structs.glsl"
      set__(active_2, color.x, padded.m[1].x);
#line 20 "tests/emit/shaders/structs.glsl"
    }
#line 20 "tests/emit/shaders/structs.glsl"
  }
#line 115 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
