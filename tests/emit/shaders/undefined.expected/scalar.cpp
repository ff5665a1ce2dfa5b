#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Thing {
  Float weight;
  array<vec2, 2> corners;
  bool operator==(const Thing&) const = default;
};

const array<Float, 3> constant = array<Float, 3>{{1.0f, 2.0f, 3.0f}};
const array<Float, 5> constant_2 = array<Float, 5>{{1.0f, 2.0f, 3.0f, 4.0f, 5.0f}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};
  array<Float, 1000> table{};
  array<vec2, 3> pairs{};
  array<Thing, 2> things{};
  int calls{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(table);
    unwritten(pairs);
    unwritten(things);
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
  void take(Thing& thing, array<Float, 3>& list, mat2& turn) {
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(thing);
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(list);
#line 7 "tests/emit/shaders/undefined.glsl"
    unwritten(turn);
#line 9 "tests/emit/shaders/undefined.glsl"
    if (iFrame > 100) {
      thing.weight = 1.0f;
#line 10 "tests/emit/shaders/undefined.glsl"
    }
#line 10 "tests/emit/shaders/undefined.glsl"
  }
#line 55 "twin.cpp"

#line 13 "tests/emit/shaders/undefined.glsl"
  vec3 missing(Float x) {
#line 15 "tests/emit/shaders/undefined.glsl"
    if (x > 9.0f) {
      return vec3(x);
#line 16 "tests/emit/shaders/undefined.glsl"
    }
#line 16 "tests/emit/shaders/undefined.glsl"
    return {};
#line 16 "tests/emit/shaders/undefined.glsl"
  }
#line 68 "twin.cpp"

#line 19 "tests/emit/shaders/undefined.glsl"
  Thing missing_thing(Float x) {
#line 21 "tests/emit/shaders/undefined.glsl"
    if (x > 9.0f) {
#line 23 "tests/emit/shaders/undefined.glsl"
      Thing thing;
#line 23 "tests/emit/shaders/undefined.glsl"
      thing.weight = 3.0f;
      return thing;
#line 24 "tests/emit/shaders/undefined.glsl"
    }
#line 24 "tests/emit/shaders/undefined.glsl"
    return {};
#line 24 "tests/emit/shaders/undefined.glsl"
  }
#line 85 "twin.cpp"

#line 28 "tests/emit/shaders/undefined.glsl"
  Float long_list(int n) {
#line 31 "tests/emit/shaders/undefined.glsl"
    array<Float, 300> list;
#line 31 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < n; i++) {
      list[i] += 1.0f;
#line 32 "tests/emit/shaders/undefined.glsl"
    }
#line 34 "tests/emit/shaders/undefined.glsl"
    Float sum;
#line 34 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < 300; i++) {
      sum += list[i];
#line 35 "tests/emit/shaders/undefined.glsl"
    }
    return sum;
#line 36 "tests/emit/shaders/undefined.glsl"
  }
#line 106 "twin.cpp"

#line 40 "tests/emit/shaders/undefined.glsl"
  int next() {
#line 40 "tests/emit/shaders/undefined.glsl"
    return calls++;
#line 40 "tests/emit/shaders/undefined.glsl"
  }
#line 114 "twin.cpp"

#line 42 "tests/emit/shaders/undefined.glsl"
  vec3 partly(Float x) {
#line 45 "tests/emit/shaders/undefined.glsl"
    vec3 color;
#line 45 "tests/emit/shaders/undefined.glsl"
    if (x < 2.0f) {
      color = vec3(1.0f, 2.0f, 3.0f);
#line 46 "tests/emit/shaders/undefined.glsl"
    } else {
      if (x < 4.0f) {
        color = vec3(4.0f);
#line 48 "tests/emit/shaders/undefined.glsl"
      } else {
#line 50 "tests/emit/shaders/undefined.glsl"
        color.x = 0.5f;
#line 50 "tests/emit/shaders/undefined.glsl"
      }
#line 50 "tests/emit/shaders/undefined.glsl"
    }
    return color;
#line 51 "tests/emit/shaders/undefined.glsl"
  }
#line 138 "twin.cpp"

#line 54 "tests/emit/shaders/undefined.glsl"
  Float rounds(Float x) {
#line 56 "tests/emit/shaders/undefined.glsl"
    Float sum = 0.0f;
    int k;
#line 57 "tests/emit/shaders/undefined.glsl"
    for (; k < 3; k++) {
      Float a = 1.0f;
      Float z;
#line 59 "tests/emit/shaders/undefined.glsl"
      for (; z < 1.0f; z += 0.25f) {
        a += fract(x * z);
#line 60 "tests/emit/shaders/undefined.glsl"
      }
      sum += a;
#line 61 "tests/emit/shaders/undefined.glsl"
    }
#line 63 "tests/emit/shaders/undefined.glsl"
    return sum;
#line 63 "tests/emit/shaders/undefined.glsl"
  }
#line 161 "twin.cpp"

#line 66 "tests/emit/shaders/undefined.glsl"
  void mainImage(vec4& c, vec2 p) {
#line 66 "tests/emit/shaders/undefined.glsl"
    unwritten(c);
#line 68 "tests/emit/shaders/undefined.glsl"
    table[make<int>(p.x)] += 1.0f;
#line 70 "tests/emit/shaders/undefined.glsl"
    Float sum;
#line 70 "tests/emit/shaders/undefined.glsl"
    for (int i = 0; i < 1000; i++) {
      sum += table[i];
#line 71 "tests/emit/shaders/undefined.glsl"
    }
    Float i;
#line 72 "tests/emit/shaders/undefined.glsl"
    Float kept;
#line 72 "tests/emit/shaders/undefined.glsl"
    for (; i < 3.0f; i++) {
#line 74 "tests/emit/shaders/undefined.glsl"
      kept += i;
      Float fresh;
#line 75 "tests/emit/shaders/undefined.glsl"
      fresh += kept;
      sum += kept + fresh;
#line 76 "tests/emit/shaders/undefined.glsl"
    }
#line 80 "tests/emit/shaders/undefined.glsl"
    Thing thing;
#line 80 "tests/emit/shaders/undefined.glsl"
    thing.weight = 5.0f;
    thing.corners[1] = p;
    array<Float, 3> list = constant;
    mat2 turn = mat2(3.0f, 0.0f, 0.0f, 3.0f);
    take(thing, list, turn);
    Float outs = thing.weight + thing.corners[1].x + list[1] + turn[1].y;
#line 87 "tests/emit/shaders/undefined.glsl"
    int far = make<int>(p.x) * 9 - 40;
    uint unsigned_far = uint(far);
    array<Float, 5> five = constant_2;
    mat3 m = mat3(1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f, 9.0f);
    five[far] += 10.0f;
    const int tmp = next();
#line 92 "tests/emit/shaders/undefined.glsl"
    five[tmp] += 100.0f;
    at(at(m, far), unsigned_far) += 1000.0f;
    Float indexed = five[0] + five[4] * 2.0f + m[0].x + m[2].z * 3.0f + at(vec3(1.0f, 2.0f, 3.0f), far) + five[unsigned_far] + Float(calls) + pairs[far].x + things[far].weight;
#line 97 "tests/emit/shaders/undefined.glsl"
    vec3 nowhere = missing(p.x) + missing_thing(p.y).weight;
    c = vec4(sum + long_list(3) + long_list(4), outs, indexed, nowhere.y + dot(partly(p.x), vec3(1.0f, 10.0f, 100.0f)) + rounds(p.y));
#line 98 "tests/emit/shaders/undefined.glsl"
  }
#line 214 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
