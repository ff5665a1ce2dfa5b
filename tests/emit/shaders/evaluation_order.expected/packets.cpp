#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Pair {
  Float a;
  Float b;
  friend void set__(Bool m, Pair& to, const Pair& from) { set__(m, to.a, from.a); set__(m, to.b, from.b); }
  friend Bool same__(const Pair& a, const Pair& b) { return Bool(true) && same__(a.a, b.a) && same__(a.b, b.b); }
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Uint state{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, state);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 51;

#line 3 "tests/emit/shaders/evaluation_order.glsl"
  Uint rnd(Bool active) {
#line 3 "tests/emit/shaders/evaluation_order.glsl"
    set__(active, state, state * 747796405u + 2891336453u);
#line 3 "tests/emit/shaders/evaluation_order.glsl"
    return state >> 9;
#line 3 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 38 "twin.cpp"

#line 4 "tests/emit/shaders/evaluation_order.glsl"
  Float f(Bool active) {
#line 4 "tests/emit/shaders/evaluation_order.glsl"
    return make<Float>(rnd(active) & 255u);
#line 4 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 46 "twin.cpp"

#line 5 "tests/emit/shaders/evaluation_order.glsl"
  Float g(Bool active, Float a, Float b, Float c) {
#line 5 "tests/emit/shaders/evaluation_order.glsl"
    return a - b * 2.0f + c * 4.0f;
#line 5 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 54 "twin.cpp"

#line 7 "tests/emit/shaders/evaluation_order.glsl"
  Float pick(Bool active, int i) {
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    const bool condition = i > 1;
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    Float tmp{};
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    if (condition) {
#line 7 "tests/emit/shaders/evaluation_order.glsl"
      tmp = f(active);
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    if (!condition) {
#line 7 "tests/emit/shaders/evaluation_order.glsl"
      tmp = Float(1.0f);
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    return tmp;
#line 7 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 78 "twin.cpp"

#line 9 "tests/emit/shaders/evaluation_order.glsl"
  vec4 late(Bool active, vec2 q) {
    Float x = q.x;
#line 10 "tests/emit/shaders/evaluation_order.glsl"
    Float y = q.x;
#line 10 "tests/emit/shaders/evaluation_order.glsl"
    Float z = q.y;
    vec2 p = q;
#line 11 "tests/emit/shaders/evaluation_order.glsl"
    vec2 r = q;
    p = p + 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const vec2 tmp = p;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_2 = x;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    x = x + 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_3 = tmp_2;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    y = y - 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_4 = y;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    r = r + 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const vec2 tmp_5 = r;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    vec4 sum = vec4(p, tmp) + vec4(x, tmp_3, max(y, tmp_4), dot(r, tmp_5));
    p = p - 0.3f;
#line 13 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_6 = length(p);
#line 13 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_7 = p.x - tmp_6;
#line 13 "tests/emit/shaders/evaluation_order.glsl"
    sum.x = sum.x + tmp_7;
    r = r * 2.0f;
#line 14 "tests/emit/shaders/evaluation_order.glsl"
    const vec2 tmp_8 = r;
#line 14 "tests/emit/shaders/evaluation_order.glsl"
    r = r + tmp_8;
    Int i = make<Int>(q.x);
    const Int tmp_9 = i;
#line 16 "tests/emit/shaders/evaluation_order.glsl"
    i = i + 1;
#line 16 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_10 = make<Float>(tmp_9);
#line 16 "tests/emit/shaders/evaluation_order.glsl"
    vec2 k = vec2(make<Float>(i), tmp_10);
    sum.z = sum.z + (k.x * 3.0f + k.y);
    z = 9.0f;
#line 18 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_11 = z;
#line 18 "tests/emit/shaders/evaluation_order.glsl"
    return sum + vec4(r, z, tmp_11);
#line 18 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 137 "twin.cpp"

#line 20 "tests/emit/shaders/evaluation_order.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 20 "tests/emit/shaders/evaluation_order.glsl"
    unwritten(active, color);
    set__(active, state, make<Uint>(p.x) + 256u * make<Uint>(p.y));
    const Float tmp = f(active);
#line 22 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_2 = f(active);
#line 22 "tests/emit/shaders/evaluation_order.glsl"
    vec3 v = vec3(tmp, tmp_2, f(active));
    const Float tmp_3 = f(active);
#line 23 "tests/emit/shaders/evaluation_order.glsl"
    Float a = tmp_3 - f(active);
    const Float tmp_4 = f(active);
#line 24 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_5 = f(active);
#line 24 "tests/emit/shaders/evaluation_order.glsl"
    Float b = g(active, tmp_4, tmp_5, f(active));
    const Float tmp_6 = f(active);
#line 25 "tests/emit/shaders/evaluation_order.glsl"
    Pair q = Pair{tmp_6, f(active)};
    const Float tmp_7 = f(active);
#line 26 "tests/emit/shaders/evaluation_order.glsl"
    array<Float, 2> list = array<Float, 2>{{tmp_7, f(active)}};
    int i = 0;
    const float tmp_8 = float(i++);
#line 28 "tests/emit/shaders/evaluation_order.glsl"
    const float tmp_9 = tmp_8 + float(i++) * 8.0f;
#line 28 "tests/emit/shaders/evaluation_order.glsl"
    float c = tmp_9 + float(++i) * 64.0f;
    const Bool tmp_10 = f(active) > 100.0f;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    Bool tmp_11 = tmp_10;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    if (Bool active_2 = active && tmp_10; any__(active_2)) {
#line 29 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, tmp_11, f(active_2) > 50.0f);
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    const Bool tmp_12 = tmp_11;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    Bool tmp_13 = tmp_12;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    if (Bool active_2 = active && !tmp_12; any__(active_2)) {
#line 29 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, tmp_13, f(active_2) < 9.0f);
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    const Bool tmp_14 = tmp_13;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    const Bool condition = tmp_14;
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    Float tmp_15{};
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 29 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, tmp_15, f(active_2));
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 29 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, tmp_15, -f(active_2));
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 29 "tests/emit/shaders/evaluation_order.glsl"
    Float d = tmp_15;
    const Float tmp_16 = pick(active, i);
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_17 = f(active) * 2.0f;
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_18 = f(active);
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    Float e = tmp_16 + (tmp_17 + (tmp_18 - f(active)));
    {
#line 31 "tests/emit/shaders/evaluation_order.glsl"
      Bool loop = active;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
      Int k = make<Int>(f(loop)) & 3;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
      for (;; [&] { const Int tmp_19 = 1 + make<Int>(rnd(loop) & 1u); k = k + tmp_19; }()) {
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        const Bool tmp_20 = k < 5;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        Bool tmp_21 = tmp_20;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        if (Bool active_2 = loop && tmp_20; any__(active_2)) {
#line 31 "tests/emit/shaders/evaluation_order.glsl"
          set__(active_2, tmp_21, f(active_2) < 250.0f);
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        }
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        loop = loop && (tmp_21);
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        if (none__(loop)) break;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        Bool active_2 = loop;
#line 31 "tests/emit/shaders/evaluation_order.glsl"
        set__(active_2, e, e + make<Float>(k));
#line 31 "tests/emit/shaders/evaluation_order.glsl"
      }
#line 31 "tests/emit/shaders/evaluation_order.glsl"
    }
    {
#line 32 "tests/emit/shaders/evaluation_order.glsl"
      Bool loop = active;
#line 32 "tests/emit/shaders/evaluation_order.glsl"
      for (;;) {
#line 32 "tests/emit/shaders/evaluation_order.glsl"
        loop = loop && (f(loop) < 200.0f);
#line 32 "tests/emit/shaders/evaluation_order.glsl"
        if (none__(loop)) break;
#line 32 "tests/emit/shaders/evaluation_order.glsl"
        Bool active_2 = loop;
#line 32 "tests/emit/shaders/evaluation_order.glsl"
        set__(active_2, e, e + 0.5f);
#line 32 "tests/emit/shaders/evaluation_order.glsl"
      }
#line 32 "tests/emit/shaders/evaluation_order.glsl"
    }
    float x = 1.0f;
    x += 1.0f;
#line 34 "tests/emit/shaders/evaluation_order.glsl"
    float y = x * 3.0f;
    set__(active, color, vec4(v.x + 256.0f * v.y, v.z + 0.5f * a, b + q.a - q.b * 0.5f, list[0] - list[1] + c));
    if (Bool active_2 = active && (mod(p.x, Float(2.0f)) > 1.0f); any__(active_2)) {
#line 36 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, color, vec4(d, e, y, f(active_2)));
#line 36 "tests/emit/shaders/evaluation_order.glsl"
    }
    if (Bool active_2 = active && (p.y > 8.0f); any__(active_2)) {
#line 37 "tests/emit/shaders/evaluation_order.glsl"
      set__(active_2, color, late(active_2, p));
#line 37 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 37 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 278 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
