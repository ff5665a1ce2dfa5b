#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 30;

#line 2 "tests/emit/shaders/loops.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/loops.glsl"
    unwritten(color);
    Float a = 0.0f;
#line 3 "tests/emit/shaders/loops.glsl"
    Float b = 0.0f;
    for (int i = 0, j = 10; i < j; i++, j--) {
#line 4 "tests/emit/shaders/loops.glsl"
      if (i == 2) {
#line 4 "tests/emit/shaders/loops.glsl"
        continue;
#line 4 "tests/emit/shaders/loops.glsl"
      }
#line 4 "tests/emit/shaders/loops.glsl"
      a += Float(i * j);
#line 4 "tests/emit/shaders/loops.glsl"
    }
    int k = make<int>(p.x) % 5;
    while (true) {
#line 6 "tests/emit/shaders/loops.glsl"
      if (k++ > 8) {
#line 6 "tests/emit/shaders/loops.glsl"
        break;
#line 6 "tests/emit/shaders/loops.glsl"
      }
#line 6 "tests/emit/shaders/loops.glsl"
      b += 1.0f;
#line 6 "tests/emit/shaders/loops.glsl"
    }
    do {
#line 7 "tests/emit/shaders/loops.glsl"
      b += 0.25f;
#line 7 "tests/emit/shaders/loops.glsl"
      k -= 2;
#line 7 "tests/emit/shaders/loops.glsl"
    } while (k > 0);
    for (;;) {
#line 8 "tests/emit/shaders/loops.glsl"
      if (b > 30.0f) {
#line 8 "tests/emit/shaders/loops.glsl"
        break;
#line 8 "tests/emit/shaders/loops.glsl"
      }
#line 8 "tests/emit/shaders/loops.glsl"
      b *= 2.0f;
#line 8 "tests/emit/shaders/loops.glsl"
    }
    Float sum = 0.0f;
    Float prev;
#line 10 "tests/emit/shaders/loops.glsl"
    for (int i = 0; i < 4; i++) {
#line 10 "tests/emit/shaders/loops.glsl"
      Float cur = Float(i) + p.y;
#line 10 "tests/emit/shaders/loops.glsl"
      if (i > 0) {
#line 10 "tests/emit/shaders/loops.glsl"
        sum += cur * prev;
#line 10 "tests/emit/shaders/loops.glsl"
      }
#line 10 "tests/emit/shaders/loops.glsl"
      prev = cur;
#line 10 "tests/emit/shaders/loops.glsl"
    }
    Float fresh = 0.0f;
    for (int i = 0; i < 4; i++) {
#line 12 "tests/emit/shaders/loops.glsl"
      Float once = 1.0f;
#line 12 "tests/emit/shaders/loops.glsl"
      once += Float(i);
#line 12 "tests/emit/shaders/loops.glsl"
      fresh += once;
#line 12 "tests/emit/shaders/loops.glsl"
      {
#line 12 "tests/emit/shaders/loops.glsl"
        Float once_2 = 2.0f;
#line 12 "tests/emit/shaders/loops.glsl"
        fresh *= once_2;
#line 12 "tests/emit/shaders/loops.glsl"
      }
#line 12 "tests/emit/shaders/loops.glsl"
    }
    for (Float t = 0.0f; t < 1.0f; t += 0.125f) {
#line 13 "tests/emit/shaders/loops.glsl"
      for (int i = 0; i < 2; i++) {
#line 13 "tests/emit/shaders/loops.glsl"
        fresh += t;
#line 13 "tests/emit/shaders/loops.glsl"
      }
#line 13 "tests/emit/shaders/loops.glsl"
    }
    int n = 0;
#line 14 "tests/emit/shaders/loops.glsl"
    int i = 3;
    for (i = 0; i < 6; ++i) {
#line 15 "tests/emit/shaders/loops.glsl"
      if (i % 2 == 0) {
#line 15 "tests/emit/shaders/loops.glsl"
        n += i;
#line 15 "tests/emit/shaders/loops.glsl"
      } else {
#line 15 "tests/emit/shaders/loops.glsl"
        n -= 1;
#line 15 "tests/emit/shaders/loops.glsl"
      }
#line 15 "tests/emit/shaders/loops.glsl"
    }
    for (int q = 7; q > 0; q >>= 1) {
#line 16 "tests/emit/shaders/loops.glsl"
    }
    for (; n < 20; n += 7) {
#line 17 "tests/emit/shaders/loops.glsl"
      int i_2 = 4;
#line 17 "tests/emit/shaders/loops.glsl"
      a += Float(i_2);
#line 17 "tests/emit/shaders/loops.glsl"
    }
#line 19 "tests/emit/shaders/loops.glsl"
    Float later;
#line 19 "tests/emit/shaders/loops.glsl"
    if (p.x > 3.0f) {
#line 19 "tests/emit/shaders/loops.glsl"
      later = 2.0f;
#line 19 "tests/emit/shaders/loops.glsl"
    } else {
#line 19 "tests/emit/shaders/loops.glsl"
      later = 3.0f;
#line 19 "tests/emit/shaders/loops.glsl"
    }
    color = vec4(a, b, sum, fresh + Float(n) + Float(i) + later);
#line 20 "tests/emit/shaders/loops.glsl"
  }
#line 153 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
