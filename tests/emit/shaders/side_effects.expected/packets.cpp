#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Int k{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    k = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 44;

#line 3 "tests/emit/shaders/side_effects.glsl"
  Int next(Bool active) {
#line 3 "tests/emit/shaders/side_effects.glsl"
    const Int tmp = k;
#line 3 "tests/emit/shaders/side_effects.glsl"
    set__(active, k, k + 1);
#line 3 "tests/emit/shaders/side_effects.glsl"
    return tmp;
#line 3 "tests/emit/shaders/side_effects.glsl"
  }
#line 33 "twin.cpp"

#line 4 "tests/emit/shaders/side_effects.glsl"
  Float take(Bool active, array<Float, 4>& list, Int i) {
#line 4 "tests/emit/shaders/side_effects.glsl"
    const Int tmp = i;
#line 4 "tests/emit/shaders/side_effects.glsl"
    Float element = at(list, tmp);
#line 4 "tests/emit/shaders/side_effects.glsl"
    set__(active, element, element + 1.0f);
#line 4 "tests/emit/shaders/side_effects.glsl"
    put__(active, list, tmp, element);
#line 4 "tests/emit/shaders/side_effects.glsl"
    return at(list, i);
#line 4 "tests/emit/shaders/side_effects.glsl"
  }
#line 49 "twin.cpp"

#line 5 "tests/emit/shaders/side_effects.glsl"
  Float both(Bool active, Float& a, Float& b) {
#line 5 "tests/emit/shaders/side_effects.glsl"
    Float t = a;
#line 5 "tests/emit/shaders/side_effects.glsl"
    set__(active, a, b);
#line 5 "tests/emit/shaders/side_effects.glsl"
    set__(active, b, t);
#line 5 "tests/emit/shaders/side_effects.glsl"
    return a - b;
#line 5 "tests/emit/shaders/side_effects.glsl"
  }
#line 63 "twin.cpp"

#line 6 "tests/emit/shaders/side_effects.glsl"
  vec3 sample_(Bool active, Uint& s) {
#line 6 "tests/emit/shaders/side_effects.glsl"
    set__(active, s, s * 1664525u + 1013904223u);
#line 6 "tests/emit/shaders/side_effects.glsl"
    return vec3(make<Float>(s >> 8), make<Float>(s >> 16), make<Float>(s >> 24)) / 256.0f;
#line 6 "tests/emit/shaders/side_effects.glsl"
  }
#line 73 "twin.cpp"

#line 7 "tests/emit/shaders/side_effects.glsl"
  Bool more(Bool active, Int& n) {
#line 7 "tests/emit/shaders/side_effects.glsl"
    set__(active, n, n - 1);
#line 7 "tests/emit/shaders/side_effects.glsl"
    return n > 0;
#line 7 "tests/emit/shaders/side_effects.glsl"
  }
#line 83 "twin.cpp"

#line 8 "tests/emit/shaders/side_effects.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/side_effects.glsl"
    unwritten(active, color);
    array<Float, 4> list = array<Float, 4>{{p.x, Float(1.0f), Float(2.0f), Float(3.0f)}};
    const Int tmp = next(active);
#line 10 "tests/emit/shaders/side_effects.glsl"
    Float element = at(list, tmp);
#line 10 "tests/emit/shaders/side_effects.glsl"
    element = element + 5.0f;
#line 10 "tests/emit/shaders/side_effects.glsl"
    put__(active, list, tmp, element);
    const Int tmp_2 = next(active);
#line 11 "tests/emit/shaders/side_effects.glsl"
    const Float tmp_3 = at(list, next(active)) * 2.0f;
#line 11 "tests/emit/shaders/side_effects.glsl"
    Float element_2 = at(list, tmp_2);
#line 11 "tests/emit/shaders/side_effects.glsl"
    element_2 = tmp_3;
#line 11 "tests/emit/shaders/side_effects.glsl"
    put__(active, list, tmp_2, element_2);
    const Float tmp_4 = take(active, list, Int(3));
#line 12 "tests/emit/shaders/side_effects.glsl"
    const Float tmp_5 = tmp_4 * take(active, list, Int(3));
#line 12 "tests/emit/shaders/side_effects.glsl"
    Float t = tmp_5 + take(active, list, k & 3);
    Float tmp_6 = list[0];
#line 13 "tests/emit/shaders/side_effects.glsl"
    Float tmp_7 = list[1];
#line 13 "tests/emit/shaders/side_effects.glsl"
    const Float tmp_8 = both(active, tmp_6, tmp_7);
#line 13 "tests/emit/shaders/side_effects.glsl"
    set__(active, list[0], tmp_6);
#line 13 "tests/emit/shaders/side_effects.glsl"
    set__(active, list[1], tmp_7);
#line 13 "tests/emit/shaders/side_effects.glsl"
    Float u = tmp_8;
    Uint s = make<Uint>(p.x) * 17u + make<Uint>(p.y);
    const vec3 tmp_9 = sample_(active, s);
#line 15 "tests/emit/shaders/side_effects.glsl"
    const vec3 tmp_10 = tmp_9 + sample_(active, s) * 2.0f;
#line 15 "tests/emit/shaders/side_effects.glsl"
    const vec3 tmp_11 = sample_(active, s);
#line 15 "tests/emit/shaders/side_effects.glsl"
    vec3 v = tmp_10 - cross(tmp_11, sample_(active, s));
    vec2 w = p;
    const Int tmp_12 = next(active) & 1;
#line 17 "tests/emit/shaders/side_effects.glsl"
    Float element_3 = at(w, tmp_12);
#line 17 "tests/emit/shaders/side_effects.glsl"
    element_3 = element_3 * 3.0f;
#line 17 "tests/emit/shaders/side_effects.glsl"
    put__(active, w, tmp_12, element_3);
    Int n = 5;
#line 18 "tests/emit/shaders/side_effects.glsl"
    Float sum = 0.0f;
    {
#line 19 "tests/emit/shaders/side_effects.glsl"
      Bool loop = active;
#line 19 "tests/emit/shaders/side_effects.glsl"
      for (;;) {
#line 19 "tests/emit/shaders/side_effects.glsl"
        loop = loop && (more(loop, n));
#line 19 "tests/emit/shaders/side_effects.glsl"
        if (none__(loop)) break;
#line 19 "tests/emit/shaders/side_effects.glsl"
        Bool active_2 = loop;
#line 19 "tests/emit/shaders/side_effects.glsl"
        set__(active_2, sum, sum + make<Float>(n));
#line 19 "tests/emit/shaders/side_effects.glsl"
      }
#line 19 "tests/emit/shaders/side_effects.glsl"
    }
    {
#line 20 "tests/emit/shaders/side_effects.glsl"
      Bool loop = active;
#line 20 "tests/emit/shaders/side_effects.glsl"
      do {
#line 20 "tests/emit/shaders/side_effects.glsl"
        Bool active_2 = loop;
#line 20 "tests/emit/shaders/side_effects.glsl"
        set__(active_2, sum, sum * 1.5f);
#line 20 "tests/emit/shaders/side_effects.glsl"
        const Bool tmp_13 = more(loop, n);
#line 20 "tests/emit/shaders/side_effects.glsl"
        Bool tmp_14 = tmp_13;
#line 20 "tests/emit/shaders/side_effects.glsl"
        if (Bool active_2 = loop && !tmp_13; any__(active_2)) {
#line 20 "tests/emit/shaders/side_effects.glsl"
          set__(active_2, tmp_14, next(active_2) < 8);
#line 20 "tests/emit/shaders/side_effects.glsl"
        }
#line 20 "tests/emit/shaders/side_effects.glsl"
        loop = loop && (tmp_14);
#line 20 "tests/emit/shaders/side_effects.glsl"
      } while (any__(loop));
#line 20 "tests/emit/shaders/side_effects.glsl"
    }
    {
#line 21 "tests/emit/shaders/side_effects.glsl"
      Bool loop = active;
#line 21 "tests/emit/shaders/side_effects.glsl"
      Int i = next(loop);
#line 21 "tests/emit/shaders/side_effects.glsl"
      for (;; set__(loop, sum, sum + make<Float>(i)), next(loop)) {
#line 21 "tests/emit/shaders/side_effects.glsl"
        loop = loop && (more(loop, i));
#line 21 "tests/emit/shaders/side_effects.glsl"
        if (none__(loop)) break;
#line 21 "tests/emit/shaders/side_effects.glsl"
        Bool active_2 = loop;
#line 21 "tests/emit/shaders/side_effects.glsl"
        if (Bool active_3 = active_2 && (sum > 100.0f); any__(active_3)) {
#line 21 "tests/emit/shaders/side_effects.glsl"
          mask_out__(active_3, active_2, loop);
#line 21 "tests/emit/shaders/side_effects.glsl"
        }
#line 21 "tests/emit/shaders/side_effects.glsl"
      }
#line 21 "tests/emit/shaders/side_effects.glsl"
    }
    mat2 m = make<mat2>(uniform::mat2(1.0f, 0.0f, 0.0f, 1.0f));
#line 22 "tests/emit/shaders/side_effects.glsl"
    const Int tmp_15 = next(active) & 1;
#line 22 "tests/emit/shaders/side_effects.glsl"
    vec2 element_4 = at(m, tmp_15);
#line 22 "tests/emit/shaders/side_effects.glsl"
    element_4 = element_4 + vec2(sum, make<Float>(k));
#line 22 "tests/emit/shaders/side_effects.glsl"
    put__(active, m, tmp_15, element_4);
    set__(active, color, vec4(t + list[0] * 0.5f, u + v.x, v.y + w.x + m[0].y, sum + w.y * 0.125f + make<Float>(k) + m[1].x));
#line 23 "tests/emit/shaders/side_effects.glsl"
  }
#line 218 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
