#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Thing {
  Float weight;
  array<vec2, 2> corners;
  friend void set__(Bool m, Thing& to, const Thing& from) { set__(m, to.weight, from.weight); set__(m, to.corners, from.corners); }
  friend Bool same__(const Thing& a, const Thing& b) { return Bool(true) && same__(a.weight, b.weight) && same__(a.corners, b.corners); }
};

const array<float, 3> constant = array<float, 3>{{1.0f, 2.0f, 3.0f}};
const array<float, 5> constant_2 = array<float, 5>{{1.0f, 2.0f, 3.0f, 4.0f, 5.0f}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};
  array<Float, 1000> table{};
  array<vec2, 3> pairs{};
  array<Thing, 2> things{};
  Int calls{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, table);
    unwritten(active, pairs);
    unwritten(active, things);
    calls = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iFrame", iFrame);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 1407;

#line 7 "tests/emit/shaders/undefined.glsl"
  void take(Bool active, Thing& thing, array<Float, 3>& list, mat2& turn) {
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(active, thing);
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(active, list);
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(active, turn);
#line 9 "tests/emit/shaders/undefined.glsl"
    if (iFrame > 100) {
      set__(active, thing.weight, 1.0f);
#line 10 "tests/emit/shaders/undefined.glsl"
    }
#line 10 "tests/emit/shaders/undefined.glsl"
  }
#line 56 "twin.cpp"

#line 13 "tests/emit/shaders/undefined.glsl"
  vec3 missing(Bool active, Float x) {
#line 13 "tests/emit/shaders/undefined.glsl"
    vec3 result{};
#line 15 "tests/emit/shaders/undefined.glsl"
    if (Bool active_2 = active && (x > 9.0f); any__(active_2)) {
      set__(active_2, result, vec3(x));
#line 16 "tests/emit/shaders/undefined.glsl"
      mask_out__(active_2, active);
#line 16 "tests/emit/shaders/undefined.glsl"
    }
#line 16 "tests/emit/shaders/undefined.glsl"
    if (none__(active)) return result;
#line 16 "tests/emit/shaders/undefined.glsl"
    return result;
#line 16 "tests/emit/shaders/undefined.glsl"
  }
#line 75 "twin.cpp"

#line 19 "tests/emit/shaders/undefined.glsl"
  Thing missing_thing(Bool active, Float x) {
#line 19 "tests/emit/shaders/undefined.glsl"
    Thing result{};
#line 21 "tests/emit/shaders/undefined.glsl"
    if (Bool active_2 = active && (x > 9.0f); any__(active_2)) {
#line 23 "tests/emit/shaders/undefined.glsl"
      Thing thing;
#line 23 "tests/emit/shaders/undefined.glsl"
      thing.weight = 3.0f;
      set__(active_2, result, thing);
#line 24 "tests/emit/shaders/undefined.glsl"
      mask_out__(active_2, active);
#line 24 "tests/emit/shaders/undefined.glsl"
    }
#line 24 "tests/emit/shaders/undefined.glsl"
    if (none__(active)) return result;
#line 24 "tests/emit/shaders/undefined.glsl"
    return result;
#line 24 "tests/emit/shaders/undefined.glsl"
  }
#line 98 "twin.cpp"

#line 28 "tests/emit/shaders/undefined.glsl"
  Float long_list(Bool active, int n) {
#line 31 "tests/emit/shaders/undefined.glsl"
    array<Float, 300> list;
#line 31 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < n; i++) {
      list[i] = list[i] + 1.0f;
#line 32 "tests/emit/shaders/undefined.glsl"
    }
#line 34 "tests/emit/shaders/undefined.glsl"
    Float sum;
#line 34 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < 300; i++) {
      sum = sum + list[i];
#line 35 "tests/emit/shaders/undefined.glsl"
    }
    return sum;
#line 36 "tests/emit/shaders/undefined.glsl"
  }
#line 119 "twin.cpp"

#line 40 "tests/emit/shaders/undefined.glsl"
  Int next(Bool active) {
#line 40 "tests/emit/shaders/undefined.glsl"
    const Int tmp = calls;
#line 40 "tests/emit/shaders/undefined.glsl"
    set__(active, calls, calls + 1);
#line 40 "tests/emit/shaders/undefined.glsl"
    return tmp;
#line 40 "tests/emit/shaders/undefined.glsl"
  }
#line 131 "twin.cpp"

#line 42 "tests/emit/shaders/undefined.glsl"
  vec3 partly(Bool active, Float x) {
#line 45 "tests/emit/shaders/undefined.glsl"
    vec3 color;
#line 45 "tests/emit/shaders/undefined.glsl"
    const Bool condition = x < 2.0f;
#line 45 "tests/emit/shaders/undefined.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
      set__(active_2, color, vec3(1.0f, 2.0f, 3.0f));
#line 46 "tests/emit/shaders/undefined.glsl"
    }
#line 46 "tests/emit/shaders/undefined.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
      const Bool condition_2 = x < 4.0f;
#line 47 "tests/emit/shaders/undefined.glsl"
      if (Bool active_3 = active_2 && condition_2; any__(active_3)) {
        set__(active_3, color, vec3(4.0f));
#line 48 "tests/emit/shaders/undefined.glsl"
      }
#line 48 "tests/emit/shaders/undefined.glsl"
      if (Bool active_3 = active_2 && !condition_2; any__(active_3)) {
#line 50 "tests/emit/shaders/undefined.glsl"
        set__(active_3, color.x, 0.5f);
#line 50 "tests/emit/shaders/undefined.glsl"
      }
#line 50 "tests/emit/shaders/undefined.glsl"
    }
    return color;
#line 51 "tests/emit/shaders/undefined.glsl"
  }
#line 163 "twin.cpp"

#line 54 "tests/emit/shaders/undefined.glsl"
  Float rounds(Bool active, Float x) {
#line 56 "tests/emit/shaders/undefined.glsl"
    Float sum = 0.0f;
    int k;
#line 57 "tests/emit/shaders/undefined.glsl"
    for (; k < 3; k++) {
      Float a = 1.0f;
      float z;
#line 59 "tests/emit/shaders/undefined.glsl"
      for (; z < 1.0f; z += 0.25f) {
        a = a + fract(x * z);
#line 60 "tests/emit/shaders/undefined.glsl"
      }
      sum = sum + a;
#line 61 "tests/emit/shaders/undefined.glsl"
    }
#line 63 "tests/emit/shaders/undefined.glsl"
    return sum;
#line 63 "tests/emit/shaders/undefined.glsl"
  }
#line 186 "twin.cpp"

#line 66 "tests/emit/shaders/undefined.glsl"
  void mainImage(Bool active, vec4& c, vec2 p) {
#line 66 "tests/emit/shaders/undefined.glsl"
    unwritten(active, c);
#line 68 "tests/emit/shaders/undefined.glsl"
    const Int tmp = make<Int>(p.x);
#line 68 "tests/emit/shaders/undefined.glsl"
    Float element = at(table, tmp);
#line 68 "tests/emit/shaders/undefined.glsl"
    set__(active, element, element + 1.0f);
#line 68 "tests/emit/shaders/undefined.glsl"
    put__(active, table, tmp, element);
#line 70 "tests/emit/shaders/undefined.glsl"
    Float sum;
#line 70 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < 1000; i++) {
      sum = sum + table[i];
#line 71 "tests/emit/shaders/undefined.glsl"
    }
    float i;
#line 72 "tests/emit/shaders/undefined.glsl"
    float kept;
#line 72 "tests/emit/shaders/undefined.glsl"
    for (; i < 3.0f; i++) {
#line 74 "tests/emit/shaders/undefined.glsl"
      kept += i;
      float fresh;
#line 75 "tests/emit/shaders/undefined.glsl"
      fresh += kept;
      sum = sum + (kept + fresh);
#line 76 "tests/emit/shaders/undefined.glsl"
    }
#line 80 "tests/emit/shaders/undefined.glsl"
    Thing thing;
#line 80 "tests/emit/shaders/undefined.glsl"
    thing.weight = 5.0f;
    thing.corners[1] = p;
    array<Float, 3> list = spread__(constant);
    mat2 turn = make<mat2>(uniform::mat2(3.0f, 0.0f, 0.0f, 3.0f));
    take(active, thing, list, turn);
    Float outs = thing.weight + thing.corners[1].x + list[1] + turn[1].y;
#line 87 "tests/emit/shaders/undefined.glsl"
    Int far = make<Int>(p.x) * 9 - 40;
    Uint unsigned_far = make<Uint>(far);
    array<Float, 5> five = spread__(constant_2);
    mat3 m = make<mat3>(uniform::mat3(1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f, 9.0f));
    const Int tmp_2 = far;
#line 91 "tests/emit/shaders/undefined.glsl"
    Float element_2 = at(five, tmp_2);
#line 91 "tests/emit/shaders/undefined.glsl"
    element_2 = element_2 + 10.0f;
#line 91 "tests/emit/shaders/undefined.glsl"
    put__(active, five, tmp_2, element_2);
    const Int tmp_3 = next(active);
#line 92 "tests/emit/shaders/undefined.glsl"
    Float element_3 = at(five, tmp_3);
#line 92 "tests/emit/shaders/undefined.glsl"
    element_3 = element_3 + 100.0f;
#line 92 "tests/emit/shaders/undefined.glsl"
    put__(active, five, tmp_3, element_3);
    const Int tmp_4 = far;
#line 93 "tests/emit/shaders/undefined.glsl"
    const Uint tmp_5 = unsigned_far;
#line 93 "tests/emit/shaders/undefined.glsl"
    vec3 element_4 = at(m, tmp_4);
#line 93 "tests/emit/shaders/undefined.glsl"
    Float element_5 = at(element_4, tmp_5);
#line 93 "tests/emit/shaders/undefined.glsl"
    element_5 = element_5 + 1000.0f;
#line 93 "tests/emit/shaders/undefined.glsl"
    put__(active, element_4, tmp_5, element_5);
#line 93 "tests/emit/shaders/undefined.glsl"
    put__(active, m, tmp_4, element_4);
    Float indexed = five[0] + five[4] * 2.0f + m[0].x + m[2].z * 3.0f + at(uniform::vec3(1.0f, 2.0f, 3.0f), far) + at(five, unsigned_far) + make<Float>(calls) + at(pairs, far).x + at(things, far).weight;
#line 97 "tests/emit/shaders/undefined.glsl"
    vec3 nowhere = missing(active, p.x) + missing_thing(active, p.y).weight;
    set__(active, c, vec4(sum + long_list(active, 3) + long_list(active, 4), outs, indexed, nowhere.y + dot(partly(active, p.x), vec3(1.0f, 10.0f, 100.0f)) + rounds(active, p.y)));
#line 98 "tests/emit/shaders/undefined.glsl"
  }
#line 267 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
