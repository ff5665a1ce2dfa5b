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
  static constexpr std::size_t components__ = 19;

#line 2 "tests/emit/shaders/switches.glsl"
  Float choose(Bool active, Int k) {
#line 2 "tests/emit/shaders/switches.glsl"
    Float result{};
    Float r = 0.0f;
    {
#line 4 "tests/emit/shaders/switches.glsl"
      const Int selector = k;
#line 4 "tests/emit/shaders/switches.glsl"
      Bool active_2 = false;
#line 4 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 0));
#line 4 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        set__(active_2, result, 1.0f);
#line 5 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2, active);
#line 5 "tests/emit/shaders/switches.glsl"
      }
#line 5 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 1));
#line 5 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        set__(active_2, r, r + 2.0f);
#line 6 "tests/emit/shaders/switches.glsl"
      }
#line 6 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 2));
#line 6 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        {
#line 7 "tests/emit/shaders/switches.glsl"
          float t = 3.0f;
#line 7 "tests/emit/shaders/switches.glsl"
          set__(active_2, r, r + t);
#line 7 "tests/emit/shaders/switches.glsl"
          mask_out__(active_2);
#line 7 "tests/emit/shaders/switches.glsl"
        }
#line 7 "tests/emit/shaders/switches.glsl"
      }
#line 7 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (!(selector == 0 || selector == 1 || selector == 2 || selector == 4 || selector == 5)));
#line 7 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        set__(active_2, r, -1.0f);
#line 8 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2);
#line 8 "tests/emit/shaders/switches.glsl"
      }
#line 8 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 4));
#line 8 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        for (int i = 0; i < 9; i++) {
#line 9 "tests/emit/shaders/switches.glsl"
          if (i == 3) {
#line 9 "tests/emit/shaders/switches.glsl"
            break;
#line 9 "tests/emit/shaders/switches.glsl"
          }
#line 9 "tests/emit/shaders/switches.glsl"
          set__(active_2, r, r + 4.0f);
#line 9 "tests/emit/shaders/switches.glsl"
        }
#line 9 "tests/emit/shaders/switches.glsl"
        set__(active_2, r, r + 0.5f);
#line 9 "tests/emit/shaders/switches.glsl"
      }
#line 9 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 5));
#line 9 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
        {
#line 10 "tests/emit/shaders/switches.glsl"
          set__(active_2, r, r * 2.0f);
#line 10 "tests/emit/shaders/switches.glsl"
        }
#line 10 "tests/emit/shaders/switches.glsl"
      }
#line 10 "tests/emit/shaders/switches.glsl"
    }
#line 10 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return result;
#line 12 "tests/emit/shaders/switches.glsl"
    Float z;
#line 12 "tests/emit/shaders/switches.glsl"
    {
#line 12 "tests/emit/shaders/switches.glsl"
      const Int selector = k % 2;
#line 12 "tests/emit/shaders/switches.glsl"
      Bool active_2 = false;
#line 12 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 0));
#line 12 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 12 "tests/emit/shaders/switches.glsl"
        set__(active_2, z, 5.0f);
#line 12 "tests/emit/shaders/switches.glsl"
        set__(active_2, r, r + z);
#line 12 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2);
#line 12 "tests/emit/shaders/switches.glsl"
      }
#line 12 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 1));
#line 12 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 12 "tests/emit/shaders/switches.glsl"
        set__(active_2, z, 7.0f);
#line 12 "tests/emit/shaders/switches.glsl"
        set__(active_2, r, r - z);
#line 12 "tests/emit/shaders/switches.glsl"
      }
#line 12 "tests/emit/shaders/switches.glsl"
    }
#line 12 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return result;
    set__(active, result, r);
#line 13 "tests/emit/shaders/switches.glsl"
    return result;
#line 13 "tests/emit/shaders/switches.glsl"
  }
#line 144 "twin.cpp"

#line 15 "tests/emit/shaders/switches.glsl"
  Float early(Bool active, Float x) {
#line 15 "tests/emit/shaders/switches.glsl"
    Float result{};
#line 15 "tests/emit/shaders/switches.glsl"
    const Bool condition = x < 2.0f;
#line 15 "tests/emit/shaders/switches.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 15 "tests/emit/shaders/switches.glsl"
      set__(active_2, result, x);
#line 15 "tests/emit/shaders/switches.glsl"
      mask_out__(active_2, active);
#line 15 "tests/emit/shaders/switches.glsl"
    }
#line 15 "tests/emit/shaders/switches.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 15 "tests/emit/shaders/switches.glsl"
      const Bool condition_2 = x < 4.0f;
#line 15 "tests/emit/shaders/switches.glsl"
      if (Bool active_3 = active_2 && condition_2; any__(active_3)) {
#line 15 "tests/emit/shaders/switches.glsl"
        set__(active_3, x, x * 2.0f);
#line 15 "tests/emit/shaders/switches.glsl"
      }
#line 15 "tests/emit/shaders/switches.glsl"
      if (Bool active_3 = active_2 && !condition_2; any__(active_3)) {
#line 15 "tests/emit/shaders/switches.glsl"
        set__(active_3, result, -x);
#line 15 "tests/emit/shaders/switches.glsl"
        mask_out__(active_3, active_2, active);
#line 15 "tests/emit/shaders/switches.glsl"
      }
#line 15 "tests/emit/shaders/switches.glsl"
    }
#line 15 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return result;
#line 15 "tests/emit/shaders/switches.glsl"
    {
#line 15 "tests/emit/shaders/switches.glsl"
      Bool loop = active;
#line 15 "tests/emit/shaders/switches.glsl"
      int i = 0;
#line 15 "tests/emit/shaders/switches.glsl"
      for (;; i++) {
#line 15 "tests/emit/shaders/switches.glsl"
        loop = loop && (i < 3);
#line 15 "tests/emit/shaders/switches.glsl"
        if (none__(loop)) break;
#line 15 "tests/emit/shaders/switches.glsl"
        Bool active_2 = loop;
#line 15 "tests/emit/shaders/switches.glsl"
        if (Bool active_3 = active_2 && (x > 5.0f); any__(active_3)) {
#line 15 "tests/emit/shaders/switches.glsl"
          set__(active_3, result, 9.0f);
#line 15 "tests/emit/shaders/switches.glsl"
          mask_out__(active_3, active_2, loop, active);
#line 15 "tests/emit/shaders/switches.glsl"
        }
#line 15 "tests/emit/shaders/switches.glsl"
      }
#line 15 "tests/emit/shaders/switches.glsl"
    }
#line 15 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return result;
#line 15 "tests/emit/shaders/switches.glsl"
    set__(active, result, x);
#line 15 "tests/emit/shaders/switches.glsl"
    return result;
#line 15 "tests/emit/shaders/switches.glsl"
  }
#line 216 "twin.cpp"

#line 16 "tests/emit/shaders/switches.glsl"
  void nothing(Bool active, Int k) {
#line 16 "tests/emit/shaders/switches.glsl"
    {
#line 16 "tests/emit/shaders/switches.glsl"
      const Int selector = k;
#line 16 "tests/emit/shaders/switches.glsl"
      Bool active_2 = false;
#line 16 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 1));
#line 16 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 16 "tests/emit/shaders/switches.glsl"
        {
#line 16 "tests/emit/shaders/switches.glsl"
          mask_out__(active_2, active);
#line 16 "tests/emit/shaders/switches.glsl"
        }
#line 16 "tests/emit/shaders/switches.glsl"
      }
#line 16 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 2 || !(selector == 1 || selector == 2)));
#line 16 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 16 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2);
#line 16 "tests/emit/shaders/switches.glsl"
      }
#line 16 "tests/emit/shaders/switches.glsl"
    }
#line 16 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return;
#line 16 "tests/emit/shaders/switches.glsl"
  }
#line 252 "twin.cpp"

#line 17 "tests/emit/shaders/switches.glsl"
  Int pick(Bool active, Uint u) {
#line 17 "tests/emit/shaders/switches.glsl"
    Int result{};
#line 17 "tests/emit/shaders/switches.glsl"
    nothing(active, make<Int>(u));
#line 17 "tests/emit/shaders/switches.glsl"
    {
#line 17 "tests/emit/shaders/switches.glsl"
      const Uint selector = u;
#line 17 "tests/emit/shaders/switches.glsl"
      Bool active_2 = false;
#line 17 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (selector == 3u));
#line 17 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 17 "tests/emit/shaders/switches.glsl"
        set__(active_2, result, 30);
#line 17 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2, active);
#line 17 "tests/emit/shaders/switches.glsl"
      }
#line 17 "tests/emit/shaders/switches.glsl"
      active_2 = active_2 || (active && (!(selector == 3u)));
#line 17 "tests/emit/shaders/switches.glsl"
      if (any__(active_2)) {
#line 17 "tests/emit/shaders/switches.glsl"
        set__(active_2, result, 40);
#line 17 "tests/emit/shaders/switches.glsl"
        mask_out__(active_2, active);
#line 17 "tests/emit/shaders/switches.glsl"
      }
#line 17 "tests/emit/shaders/switches.glsl"
    }
#line 17 "tests/emit/shaders/switches.glsl"
    if (none__(active)) return result;
#line 17 "tests/emit/shaders/switches.glsl"
    return result;
#line 17 "tests/emit/shaders/switches.glsl"
  }
#line 294 "twin.cpp"

#line 18 "tests/emit/shaders/switches.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
    set__(active, color, vec4(choose(active, make<Int>(p.x)), early(active, p.x), make<Float>(pick(active, make<Uint>(p.y))), early(active, p.y)));
#line 19 "tests/emit/shaders/switches.glsl"
  }
#line 301 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
