#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

const array<Float, 3> weights = array<Float, 3>{{0.25f, 0.5f, 0.125f}};
const array<mat2, 2> turns = array<mat2, 2>{{mat2(0.0f, 1.0f, -1.0f, 0.0f), mat2(0.5f, 0.0f, 0.0f, 0.5f)}};
const array<vec3, 4> palette = array<vec3, 4>{{vec3(0.1f, 0.2f, 0.3f), vec3(1.0f), vec3(0.5f, 0.25f, 0.125f), vec3(-1.0f, 2.0f, 7.0f)}};
const array<int, 5> steps = array<int, 5>{{3, 1, 4, 1, 5}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  array<Float, 6> table{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(table);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 68;

#line 6 "tests/emit/shaders/arrays.glsl"
  Float total(array<Float, 6> v) {
#line 6 "tests/emit/shaders/arrays.glsl"
    v[0] = 100.0f;
#line 6 "tests/emit/shaders/arrays.glsl"
    Float s = 0.0f;
#line 6 "tests/emit/shaders/arrays.glsl"
    for (int i = 0; i < 6; i++) {
#line 6 "tests/emit/shaders/arrays.glsl"
      s += v[i];
#line 6 "tests/emit/shaders/arrays.glsl"
    }
#line 6 "tests/emit/shaders/arrays.glsl"
    return s;
#line 6 "tests/emit/shaders/arrays.glsl"
  }
#line 44 "twin.cpp"

#line 7 "tests/emit/shaders/arrays.glsl"
  array<Float, 2> both(Float a) {
#line 7 "tests/emit/shaders/arrays.glsl"
    return array<Float, 2>{{a, a * a}};
#line 7 "tests/emit/shaders/arrays.glsl"
  }
#line 52 "twin.cpp"

#line 8 "tests/emit/shaders/arrays.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/arrays.glsl"
    unwritten(color);
    int k = make<int>(p.x) % 8;
    for (int i = 0; i < 6; ++i) {
#line 10 "tests/emit/shaders/arrays.glsl"
      table[i] = Float(i * i);
#line 10 "tests/emit/shaders/arrays.glsl"
    }
#line 12 "tests/emit/shaders/arrays.glsl"
    Float w = 0.0f;
    for (int i = 0; i < 3; i++) {
#line 13 "tests/emit/shaders/arrays.glsl"
      w += weights[i] * Float(i + 1);
#line 13 "tests/emit/shaders/arrays.glsl"
    }
#line 15 "tests/emit/shaders/arrays.glsl"
    array<Float, 3> local;
#line 15 "tests/emit/shaders/arrays.glsl"
    local[k % 3] = 2.0f;
    array<Float, 3> copy = local;
    copy[0] += 1.0f;
    vec2 turned = turns[k & 1] * vec2(1.0f, 2.0f);
    color = vec4(at(palette[clamp(k, 0, 3)], k % 3), Float(steps[k % 5]) + total(table) * 16.0f, w + both(p.y)[1], turned.x);
    if (p.y > 3.0f) {
#line 20 "tests/emit/shaders/arrays.glsl"
      color = vec4(local[0] + local[1], copy[0], copy == local ? 1.0f : 0.0f, table[5]);
#line 20 "tests/emit/shaders/arrays.glsl"
    }
#line 20 "tests/emit/shaders/arrays.glsl"
  }
#line 86 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
