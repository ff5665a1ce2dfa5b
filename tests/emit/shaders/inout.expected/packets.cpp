#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 shared_value{};
  Float counter{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    shared_value = vec3(1.0f, 2.0f, 3.0f);
    counter = 0.0f;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 46;

#line 4 "tests/emit/shaders/inout.glsl"
  void add(Bool active, Float& a, Float b, Float& c) {
#line 4 "tests/emit/shaders/inout.glsl"
    set__(active, a, a + b);
#line 4 "tests/emit/shaders/inout.glsl"
    set__(active, c, a * 2.0f);
#line 4 "tests/emit/shaders/inout.glsl"
  }
#line 33 "twin.cpp"

#line 5 "tests/emit/shaders/inout.glsl"
  void write(Bool active, vec2& v, Float x) {
#line 5 "tests/emit/shaders/inout.glsl"
    set__(active, v, vec2(x, -x));
#line 5 "tests/emit/shaders/inout.glsl"
  }
#line 41 "twin.cpp"

#line 6 "tests/emit/shaders/inout.glsl"
  Float touch_global(Bool active, vec3& v) {
#line 6 "tests/emit/shaders/inout.glsl"
    set__(active, v.x, 10.0f);
#line 6 "tests/emit/shaders/inout.glsl"
    set__(active, counter, counter + shared_value.x);
#line 6 "tests/emit/shaders/inout.glsl"
    set__(active, shared_value.y, 5.0f);
#line 6 "tests/emit/shaders/inout.glsl"
    return shared_value.x + v.y;
#line 6 "tests/emit/shaders/inout.glsl"
  }
#line 55 "twin.cpp"

#line 7 "tests/emit/shaders/inout.glsl"
  Float next(Bool active, Float& s) {
#line 7 "tests/emit/shaders/inout.glsl"
    set__(active, s, s + 0.25f);
#line 7 "tests/emit/shaders/inout.glsl"
    return s;
#line 7 "tests/emit/shaders/inout.glsl"
  }
#line 65 "twin.cpp"

#line 8 "tests/emit/shaders/inout.glsl"
  void half_written(Bool active, vec4& v, float x) {
#line 8 "tests/emit/shaders/inout.glsl"
    unwritten(active, v);
#line 8 "tests/emit/shaders/inout.glsl"
    if (x > 0.5f) {
#line 8 "tests/emit/shaders/inout.glsl"
      set__(active, swizzle<0, 1>(v), vec2(uniform::vec2(x)));
#line 8 "tests/emit/shaders/inout.glsl"
    }
#line 8 "tests/emit/shaders/inout.glsl"
    set__(active, v.z, 1.0f);
#line 8 "tests/emit/shaders/inout.glsl"
  }
#line 81 "twin.cpp"

#line 9 "tests/emit/shaders/inout.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 9 "tests/emit/shaders/inout.glsl"
    unwritten(active, color);
    Float x = p.x / 8.0f;
    vec4 v = vec4(x, 2.0f, 3.0f, 4.0f);
    vec2 tmp = v.zx();
#line 12 "tests/emit/shaders/inout.glsl"
    write(active, tmp, x);
#line 12 "tests/emit/shaders/inout.glsl"
    set__(active, swizzle<2, 0>(v), tmp);
    array<Float, 3> list = array<Float, 3>{{x, Float(1.0f), Float(2.0f)}};
    int i = 1;
    Float tmp_2 = list[i];
#line 15 "tests/emit/shaders/inout.glsl"
    Float tmp_3 = list[2];
#line 15 "tests/emit/shaders/inout.glsl"
    add(active, tmp_2, v.x, tmp_3);
#line 15 "tests/emit/shaders/inout.glsl"
    set__(active, list[i], tmp_2);
#line 15 "tests/emit/shaders/inout.glsl"
    set__(active, list[2], tmp_3);
    Float tmp_4 = v.y;
#line 16 "tests/emit/shaders/inout.glsl"
    Float tmp_5 = v.w;
#line 16 "tests/emit/shaders/inout.glsl"
    add(active, tmp_4, v.y, tmp_5);
#line 16 "tests/emit/shaders/inout.glsl"
    set__(active, v.y, tmp_4);
#line 16 "tests/emit/shaders/inout.glsl"
    set__(active, v.w, tmp_5);
    vec3 tmp_6 = shared_value;
#line 17 "tests/emit/shaders/inout.glsl"
    const Float tmp_7 = touch_global(active, tmp_6);
#line 17 "tests/emit/shaders/inout.glsl"
    set__(active, shared_value, tmp_6);
#line 17 "tests/emit/shaders/inout.glsl"
    Float r = tmp_7;
    Float s = x;
    const Float tmp_8 = next(active, s);
#line 19 "tests/emit/shaders/inout.glsl"
    vec2 pair = vec2(tmp_8, next(active, s));
    const Float tmp_9 = next(active, s) * 2.0f;
#line 20 "tests/emit/shaders/inout.glsl"
    const Float tmp_10 = tmp_9 - next(active, s);
#line 20 "tests/emit/shaders/inout.glsl"
    Float sum = tmp_10 + s;
    set__(active, color, vec4(v.x + v.z * 4.0f, r + shared_value.x * 100.0f + shared_value.y, pair.x + pair.y * 16.0f, sum));
    if (Bool active_2 = active && (p.y < 2.0f); any__(active_2)) {
#line 22 "tests/emit/shaders/inout.glsl"
      set__(active_2, color, v);
#line 22 "tests/emit/shaders/inout.glsl"
    }
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 23 "tests/emit/shaders/inout.glsl"
      set__(active_2, color, vec4(list[0], list[1], list[2], counter));
#line 23 "tests/emit/shaders/inout.glsl"
    }
#line 23 "tests/emit/shaders/inout.glsl"
  }
#line 143 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
