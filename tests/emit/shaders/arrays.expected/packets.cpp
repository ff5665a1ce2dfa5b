#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

const array<float, 3> weights = array<float, 3>{{0.25f, 0.5f, 0.125f}};
const array<uniform::mat2, 2> turns = array<uniform::mat2, 2>{{uniform::mat2(0.0f, 1.0f, -1.0f, 0.0f), uniform::mat2(0.5f, 0.0f, 0.0f, 0.5f)}};
const array<uniform::vec3, 4> palette = array<uniform::vec3, 4>{{uniform::vec3(0.1f, 0.2f, 0.3f), uniform::vec3(1.0f), uniform::vec3(0.5f, 0.25f, 0.125f), uniform::vec3(-1.0f, 2.0f, 7.0f)}};
const array<int, 5> steps = array<int, 5>{{3, 1, 4, 1, 5}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  array<Float, 6> table{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, table);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 68;

#line 6 "tests/emit/shaders/arrays.glsl"
  Float total(Bool active, array<Float, 6> v) {
#line 6 "tests/emit/shaders/arrays.glsl"
    v[0] = 100.0f;
#line 6 "tests/emit/shaders/arrays.glsl"
    Float s = 0.0f;
#line 6 "tests/emit/shaders/arrays.glsl"
    for (int i = 0; i < 6; i++) {
#line 6 "tests/emit/shaders/arrays.glsl"
      s = s + v[i];
#line 6 "tests/emit/shaders/arrays.glsl"
    }
#line 6 "tests/emit/shaders/arrays.glsl"
    return s;
#line 6 "tests/emit/shaders/arrays.glsl"
  }
#line 44 "twin.cpp"

#line 7 "tests/emit/shaders/arrays.glsl"
  array<Float, 2> both(Bool active, Float a) {
#line 7 "tests/emit/shaders/arrays.glsl"
    return array<Float, 2>{{a, a * a}};
#line 7 "tests/emit/shaders/arrays.glsl"
  }
#line 52 "twin.cpp"

#line 8 "tests/emit/shaders/arrays.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/arrays.glsl"
    unwritten(active, color);
    Int k = make<Int>(p.x) % 8;
    for (int i = 0; i < 6; ++i) {
#line 10 "tests/emit/shaders/arrays.glsl"
      set__(active, table[i], float(i * i));
#line 10 "tests/emit/shaders/arrays.glsl"
    }
#line 12 "tests/emit/shaders/arrays.glsl"
    float w = 0.0f;
    for (int i = 0; i < 3; i++) {
#line 13 "tests/emit/shaders/arrays.glsl"
      w += weights[i] * float(i + 1);
#line 13 "tests/emit/shaders/arrays.glsl"
    }
#line 15 "tests/emit/shaders/arrays.glsl"
    array<Float, 3> local;
#line 15 "tests/emit/shaders/arrays.glsl"
    const Int tmp = k % 3;
#line 15 "tests/emit/shaders/arrays.glsl"
    Float element = at(local, tmp);
#line 15 "tests/emit/shaders/arrays.glsl"
    element = 2.0f;
#line 15 "tests/emit/shaders/arrays.glsl"
    put__(active, local, tmp, element);
    array<Float, 3> copy = local;
    copy[0] = copy[0] + 1.0f;
    vec2 turned = at(turns, k & 1) * vec2(1.0f, 2.0f);
    set__(active, color, vec4(at(at(palette, clamp(k, Int(0), Int(3))), k % 3), make<Float>(at(steps, k % 5)) + total(active, table) * 16.0f, w + both(active, p.y)[1], turned.x));
    if (Bool active_2 = active && (p.y > 3.0f); any__(active_2)) {
#line 20 "tests/emit/shaders/arrays.glsl"
      set__(active_2, color, vec4(local[0] + local[1], copy[0], select__(same__(copy, local), Float(1.0f), Float(0.0f)), table[5]));
#line 20 "tests/emit/shaders/arrays.glsl"
    }
#line 20 "tests/emit/shaders/arrays.glsl"
  }
#line 92 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
