#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 30;

#line 2 "tests/emit/shaders/loops.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/loops.glsl"
    unwritten(active, color);
    float a = 0.0f;
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
      a += float(i * j);
#line 4 "tests/emit/shaders/loops.glsl"
    }
    Int k = make<Int>(p.x) % 5;
    {
#line 6 "tests/emit/shaders/loops.glsl"
      Bool loop = active;
#line 6 "tests/emit/shaders/loops.glsl"
      for (;;) {
#line 6 "tests/emit/shaders/loops.glsl"
        loop = loop && (true);
#line 6 "tests/emit/shaders/loops.glsl"
        if (none__(loop)) break;
#line 6 "tests/emit/shaders/loops.glsl"
        Bool active_2 = loop;
#line 6 "tests/emit/shaders/loops.glsl"
        const Int tmp = k;
#line 6 "tests/emit/shaders/loops.glsl"
        set__(active_2, k, k + 1);
#line 6 "tests/emit/shaders/loops.glsl"
        if (Bool active_3 = active_2 && (tmp > 8); any__(active_3)) {
#line 6 "tests/emit/shaders/loops.glsl"
          mask_out__(active_3, active_2, loop);
#line 6 "tests/emit/shaders/loops.glsl"
        }
#line 6 "tests/emit/shaders/loops.glsl"
        if (none__(active_2)) continue;
#line 6 "tests/emit/shaders/loops.glsl"
        set__(active_2, b, b + 1.0f);
#line 6 "tests/emit/shaders/loops.glsl"
      }
#line 6 "tests/emit/shaders/loops.glsl"
    }
    {
#line 7 "tests/emit/shaders/loops.glsl"
      Bool loop = active;
#line 7 "tests/emit/shaders/loops.glsl"
      do {
#line 7 "tests/emit/shaders/loops.glsl"
        Bool active_2 = loop;
#line 7 "tests/emit/shaders/loops.glsl"
        set__(active_2, b, b + 0.25f);
#line 7 "tests/emit/shaders/loops.glsl"
        set__(active_2, k, k - 2);
#line 7 "tests/emit/shaders/loops.glsl"
        loop = loop && (k > 0);
#line 7 "tests/emit/shaders/loops.glsl"
      } while (any__(loop));
#line 7 "tests/emit/shaders/loops.glsl"
    }
    {
#line 8 "tests/emit/shaders/loops.glsl"
      Bool loop = active;
#line 8 "tests/emit/shaders/loops.glsl"
      for (;;) {
#line 8 "tests/emit/shaders/loops.glsl"
        if (none__(loop)) break;
#line 8 "tests/emit/shaders/loops.glsl"
        Bool active_2 = loop;
#line 8 "tests/emit/shaders/loops.glsl"
        if (Bool active_3 = active_2 && (b > 30.0f); any__(active_3)) {
#line 8 "tests/emit/shaders/loops.glsl"
          mask_out__(active_3, active_2, loop);
#line 8 "tests/emit/shaders/loops.glsl"
        }
#line 8 "tests/emit/shaders/loops.glsl"
        if (none__(active_2)) continue;
#line 8 "tests/emit/shaders/loops.glsl"
        set__(active_2, b, b * 2.0f);
#line 8 "tests/emit/shaders/loops.glsl"
      }
#line 8 "tests/emit/shaders/loops.glsl"
    }
    Float sum = 0.0f;
    Float prev;
#line 10 "tests/emit/shaders/loops.glsl"
    for (int i = 0; i < 4; i++) {
#line 10 "tests/emit/shaders/loops.glsl"
      Float cur = float(i) + p.y;
#line 10 "tests/emit/shaders/loops.glsl"
      if (i > 0) {
#line 10 "tests/emit/shaders/loops.glsl"
        sum = sum + cur * prev;
#line 10 "tests/emit/shaders/loops.glsl"
      }
#line 10 "tests/emit/shaders/loops.glsl"
      prev = cur;
#line 10 "tests/emit/shaders/loops.glsl"
    }
    float fresh = 0.0f;
    for (int i = 0; i < 4; i++) {
#line 12 "tests/emit/shaders/loops.glsl"
      float once = 1.0f;
#line 12 "tests/emit/shaders/loops.glsl"
      once += float(i);
#line 12 "tests/emit/shaders/loops.glsl"
      fresh += once;
#line 12 "tests/emit/shaders/loops.glsl"
      {
#line 12 "tests/emit/shaders/loops.glsl"
        float once_2 = 2.0f;
#line 12 "tests/emit/shaders/loops.glsl"
        fresh *= once_2;
#line 12 "tests/emit/shaders/loops.glsl"
      }
#line 12 "tests/emit/shaders/loops.glsl"
    }
    for (float t = 0.0f; t < 1.0f; t += 0.125f) {
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
      a += float(i_2);
#line 17 "tests/emit/shaders/loops.glsl"
    }
#line 19 "tests/emit/shaders/loops.glsl"
    Float later;
#line 19 "tests/emit/shaders/loops.glsl"
    const Bool condition = p.x > 3.0f;
#line 19 "tests/emit/shaders/loops.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 19 "tests/emit/shaders/loops.glsl"
      set__(active_2, later, 2.0f);
#line 19 "tests/emit/shaders/loops.glsl"
    }
#line 19 "tests/emit/shaders/loops.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 19 "tests/emit/shaders/loops.glsl"
      set__(active_2, later, 3.0f);
#line 19 "tests/emit/shaders/loops.glsl"
    }
    set__(active, color, vec4(a, b, sum, fresh + float(n) + float(i) + later));
#line 20 "tests/emit/shaders/loops.glsl"
  }
#line 197 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
