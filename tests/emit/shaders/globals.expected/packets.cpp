#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct S {
  Float x;
  vec2 y;
  friend void set__(Bool m, S& to, const S& from) { set__(m, to.x, from.x); set__(m, to.y, from.y); }
  friend Bool same__(const S& a, const S& b) { return Bool(true) && same__(a.x, b.x) && same__(a.y, b.y); }
};

const uniform::vec2 kk = uniform::vec2(1.25f, 1.0f);
const array<float, 3> constant = array<float, 3>{{1.0f, 2.0f, 3.0f}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float a{};
  vec3 b{};
  Int count{};
  Float c{};
  Float d{};
  array<Float, 3> list{};
  mat2 m{};
  S s{};
  vec4 unused{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, c);
    unwritten(active, unused);
    a = 1.0f;
    b = vec3(2.0f, 4.0f, 6.0f);
    count = 3;
    d = 4.0f;
    list = spread__(constant);
    m = make<mat2>(uniform::mat2(1.0f, 0.0f, 0.0f, 1.0f));
    s = S{1.0f, vec2(2.0f)};
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 36;

#line 9 "tests/emit/shaders/globals.glsl"
  Float step__(Bool active) {
#line 9 "tests/emit/shaders/globals.glsl"
    set__(active, a, a + 1.0f);
#line 9 "tests/emit/shaders/globals.glsl"
    set__(active, count, count - 1);
#line 9 "tests/emit/shaders/globals.glsl"
    set__(active, list[1], list[1] * 2.0f);
#line 9 "tests/emit/shaders/globals.glsl"
    set__(active, s.y.x, s.y.x + a);
#line 9 "tests/emit/shaders/globals.glsl"
    return a;
#line 9 "tests/emit/shaders/globals.glsl"
  }
#line 63 "twin.cpp"

#line 10 "tests/emit/shaders/globals.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 10 "tests/emit/shaders/globals.glsl"
    unwritten(active, color);
    set__(active, swizzle<0, 1>(b), p);
#line 11 "tests/emit/shaders/globals.glsl"
    const Float tmp = step__(active);
#line 11 "tests/emit/shaders/globals.glsl"
    set__(active, c, tmp + step__(active) * 8.0f);
#line 11 "tests/emit/shaders/globals.glsl"
    set__(active, m[1], m[1] * p);
    for (int i = 0; i < 2; i++) {
#line 12 "tests/emit/shaders/globals.glsl"
      set__(active, c, c + (list[i] + make<Float>(count)));
#line 12 "tests/emit/shaders/globals.glsl"
    }
    set__(active, color, vec4(a + c, b.x + d, vec2(kk) + s.y * m));
#line 13 "tests/emit/shaders/globals.glsl"
  }
#line 84 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
