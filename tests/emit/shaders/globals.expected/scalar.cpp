#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct S {
  Float x;
  vec2 y;
  bool operator==(const S&) const = default;
};

const vec2 kk = vec2(1.25f, 1.0f);
const array<Float, 3> constant = array<Float, 3>{{1.0f, 2.0f, 3.0f}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float a{};
  vec3 b{};
  int count{};
  Float c{};
  Float d{};
  array<Float, 3> list{};
  mat2 m{};
  S s{};
  vec4 unused{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(c);
    unwritten(unused);
    a = 1.0f;
    b = vec3(2.0f, 4.0f, 6.0f);
    count = 3;
    d = 4.0f;
    list = constant;
    m = mat2(1.0f, 0.0f, 0.0f, 1.0f);
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
  Float step__() {
#line 9 "tests/emit/shaders/globals.glsl"
    a += 1.0f;
#line 9 "tests/emit/shaders/globals.glsl"
    count--;
#line 9 "tests/emit/shaders/globals.glsl"
    list[1] *= 2.0f;
#line 9 "tests/emit/shaders/globals.glsl"
    s.y.x += a;
#line 9 "tests/emit/shaders/globals.glsl"
    return a;
#line 9 "tests/emit/shaders/globals.glsl"
  }
#line 62 "twin.cpp"

#line 10 "tests/emit/shaders/globals.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 10 "tests/emit/shaders/globals.glsl"
    unwritten(color);
    swizzle<0, 1>(b) = p;
#line 11 "tests/emit/shaders/globals.glsl"
    const Float tmp = step__();
#line 11 "tests/emit/shaders/globals.glsl"
    c = tmp + step__() * 8.0f;
#line 11 "tests/emit/shaders/globals.glsl"
    m[1] *= p;
    for (int i = 0; i < 2; i++) {
#line 12 "tests/emit/shaders/globals.glsl"
      c += list[i] + Float(count);
#line 12 "tests/emit/shaders/globals.glsl"
    }
    color = vec4(a + c, b.x + d, kk + s.y * m);
#line 13 "tests/emit/shaders/globals.glsl"
  }
#line 83 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
