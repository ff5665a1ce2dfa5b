#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Int calls{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    calls = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 25;

#line 3 "tests/emit/shaders/ternary.glsl"
  Bool tick(Bool active, Bool b) {
#line 3 "tests/emit/shaders/ternary.glsl"
    set__(active, calls, calls + 1);
#line 3 "tests/emit/shaders/ternary.glsl"
    return b;
#line 3 "tests/emit/shaders/ternary.glsl"
  }
#line 31 "twin.cpp"

#line 4 "tests/emit/shaders/ternary.glsl"
  Float bump(Bool active, Float& x) {
#line 4 "tests/emit/shaders/ternary.glsl"
    set__(active, x, x + 1.0f);
#line 4 "tests/emit/shaders/ternary.glsl"
    return x;
#line 4 "tests/emit/shaders/ternary.glsl"
  }
#line 41 "twin.cpp"

#line 5 "tests/emit/shaders/ternary.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 5 "tests/emit/shaders/ternary.glsl"
    unwritten(active, color);
    Float x = p.x;
#line 6 "tests/emit/shaders/ternary.glsl"
    Float y = p.y;
    const Bool tmp = tick(active, x > 3.0f);
#line 7 "tests/emit/shaders/ternary.glsl"
    Bool tmp_2 = tmp;
#line 7 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && tmp; any__(active_2)) {
#line 7 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_2, tick(active_2, y > 3.0f));
#line 7 "tests/emit/shaders/ternary.glsl"
    }
#line 7 "tests/emit/shaders/ternary.glsl"
    Bool a = tmp_2;
#line 7 "tests/emit/shaders/ternary.glsl"
    const Bool tmp_3 = tick(active, x > 5.0f);
#line 7 "tests/emit/shaders/ternary.glsl"
    Bool tmp_4 = tmp_3;
#line 7 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && !tmp_3; any__(active_2)) {
#line 7 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_4, tick(active_2, y > 5.0f));
#line 7 "tests/emit/shaders/ternary.glsl"
    }
#line 7 "tests/emit/shaders/ternary.glsl"
    Bool b = tmp_4;
#line 7 "tests/emit/shaders/ternary.glsl"
    const Bool tmp_5 = tick(active, a);
#line 7 "tests/emit/shaders/ternary.glsl"
    Bool c = tmp_5 != tick(active, b);
    const Bool condition = x > y;
#line 8 "tests/emit/shaders/ternary.glsl"
    Float tmp_6{};
#line 8 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 8 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_6, bump(active_2, x));
#line 8 "tests/emit/shaders/ternary.glsl"
    }
#line 8 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 8 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_6, bump(active_2, y));
#line 8 "tests/emit/shaders/ternary.glsl"
    }
#line 8 "tests/emit/shaders/ternary.glsl"
    Float r = tmp_6;
    Float z = select__(x > 4.0f, select__(y > 2.0f, Float(1.0f), Float(2.0f)), Float(3.0f));
    x = y + 1.0f;
#line 10 "tests/emit/shaders/ternary.glsl"
    Float w = x * 2.0f;
    int i = 0;
#line 11 "tests/emit/shaders/ternary.glsl"
    i += i = 3;
    const Bool condition_2 = a;
#line 12 "tests/emit/shaders/ternary.glsl"
    Float tmp_7{};
#line 12 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && condition_2; any__(active_2)) {
#line 12 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_7, bump(active_2, x) + bump(active_2, y));
#line 12 "tests/emit/shaders/ternary.glsl"
    }
#line 12 "tests/emit/shaders/ternary.glsl"
    if (Bool active_2 = active && !condition_2; any__(active_2)) {
#line 12 "tests/emit/shaders/ternary.glsl"
      const Bool condition_3 = b && c;
#line 12 "tests/emit/shaders/ternary.glsl"
      Float tmp_8{};
#line 12 "tests/emit/shaders/ternary.glsl"
      if (Bool active_3 = active_2 && condition_3; any__(active_3)) {
#line 12 "tests/emit/shaders/ternary.glsl"
        set__(active_3, tmp_8, Float(-1.0f));
#line 12 "tests/emit/shaders/ternary.glsl"
      }
#line 12 "tests/emit/shaders/ternary.glsl"
      if (Bool active_3 = active_2 && !condition_3; any__(active_3)) {
#line 12 "tests/emit/shaders/ternary.glsl"
        set__(active_3, tmp_8, bump(active_3, x) * 0.5f);
#line 12 "tests/emit/shaders/ternary.glsl"
      }
#line 12 "tests/emit/shaders/ternary.glsl"
      set__(active_2, tmp_7, tmp_8);
#line 12 "tests/emit/shaders/ternary.glsl"
    }
#line 12 "tests/emit/shaders/ternary.glsl"
    Float s = tmp_7;
    uniform::vec2 v = uniform::vec2(1.0f);
#line 13 "tests/emit/shaders/ternary.glsl"
    swizzle<1, 0>(v) = v *= 2.0f;
    if (Bool active_2 = active && (!(a || b) && c == false); any__(active_2)) {
#line 14 "tests/emit/shaders/ternary.glsl"
      set__(active_2, s, s + 0.5f);
#line 14 "tests/emit/shaders/ternary.glsl"
    }
    set__(active, color, vec4(r + z * 8.0f, w + make<Float>(calls) * 32.0f, s + float(i), v.x + v.y + x - y));
#line 15 "tests/emit/shaders/ternary.glsl"
  }
#line 145 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
