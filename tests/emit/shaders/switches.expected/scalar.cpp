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
  static constexpr std::size_t components__ = 19;

#line 2 "tests/emit/shaders/switches.glsl"
  Float choose(int k) {
    Float r = 0.0f;
    switch (k) {
      case 0:
#line 5 "tests/emit/shaders/switches.glsl"
      {
#line 5 "tests/emit/shaders/switches.glsl"
        return 1.0f;
#line 5 "tests/emit/shaders/switches.glsl"
      }
#line 5 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
      case 1:
#line 6 "tests/emit/shaders/switches.glsl"
      {
#line 6 "tests/emit/shaders/switches.glsl"
        r += 2.0f;
#line 6 "tests/emit/shaders/switches.glsl"
      }
#line 6 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
      case 2:
#line 7 "tests/emit/shaders/switches.glsl"
      {
#line 7 "tests/emit/shaders/switches.glsl"
        {
#line 7 "tests/emit/shaders/switches.glsl"
          Float t = 3.0f;
#line 7 "tests/emit/shaders/switches.glsl"
          r += t;
#line 7 "tests/emit/shaders/switches.glsl"
          break;
#line 7 "tests/emit/shaders/switches.glsl"
        }
#line 7 "tests/emit/shaders/switches.glsl"
      }
#line 7 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
      default:
#line 8 "tests/emit/shaders/switches.glsl"
      {
#line 8 "tests/emit/shaders/switches.glsl"
        r = -1.0f;
#line 8 "tests/emit/shaders/switches.glsl"
        break;
#line 8 "tests/emit/shaders/switches.glsl"
      }
#line 8 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
      case 4:
#line 9 "tests/emit/shaders/switches.glsl"
      {
#line 9 "tests/emit/shaders/switches.glsl"
        for (int i = 0; i < 9; i++) {
#line 9 "tests/emit/shaders/switches.glsl"
          if (i == 3) {
#line 9 "tests/emit/shaders/switches.glsl"
            break;
#line 9 "tests/emit/shaders/switches.glsl"
          }
#line 9 "tests/emit/shaders/switches.glsl"
          r += 4.0f;
#line 9 "tests/emit/shaders/switches.glsl"
        }
#line 9 "tests/emit/shaders/switches.glsl"
        r += 0.5f;
#line 9 "tests/emit/shaders/switches.glsl"
      }
#line 9 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
      case 5:
#line 10 "tests/emit/shaders/switches.glsl"
      {
#line 10 "tests/emit/shaders/switches.glsl"
        {
#line 10 "tests/emit/shaders/switches.glsl"
          r *= 2.0f;
#line 10 "tests/emit/shaders/switches.glsl"
        }
#line 10 "tests/emit/shaders/switches.glsl"
      }
#line 10 "tests/emit/shaders/switches.glsl"
    }
#line 12 "tests/emit/shaders/switches.glsl"
    Float z;
#line 12 "tests/emit/shaders/switches.glsl"
    switch (k % 2) {
#line 12 "tests/emit/shaders/switches.glsl"
      case 0:
#line 12 "tests/emit/shaders/switches.glsl"
      {
#line 12 "tests/emit/shaders/switches.glsl"
        z = 5.0f;
#line 12 "tests/emit/shaders/switches.glsl"
        r += z;
#line 12 "tests/emit/shaders/switches.glsl"
        break;
#line 12 "tests/emit/shaders/switches.glsl"
      }
#line 12 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
#line 12 "tests/emit/shaders/switches.glsl"
      case 1:
#line 12 "tests/emit/shaders/switches.glsl"
      {
#line 12 "tests/emit/shaders/switches.glsl"
        z = 7.0f;
#line 12 "tests/emit/shaders/switches.glsl"
        r -= z;
#line 12 "tests/emit/shaders/switches.glsl"
      }
#line 12 "tests/emit/shaders/switches.glsl"
    }
    return r;
#line 13 "tests/emit/shaders/switches.glsl"
  }
#line 138 "twin.cpp"

#line 15 "tests/emit/shaders/switches.glsl"
  Float early(Float x) {
#line 15 "tests/emit/shaders/switches.glsl"
    if (x < 2.0f) {
#line 15 "tests/emit/shaders/switches.glsl"
      return x;
#line 15 "tests/emit/shaders/switches.glsl"
    } else {
#line 15 "tests/emit/shaders/switches.glsl"
      if (x < 4.0f) {
#line 15 "tests/emit/shaders/switches.glsl"
        x *= 2.0f;
#line 15 "tests/emit/shaders/switches.glsl"
      } else {
#line 15 "tests/emit/shaders/switches.glsl"
        return -x;
#line 15 "tests/emit/shaders/switches.glsl"
      }
#line 15 "tests/emit/shaders/switches.glsl"
    }
#line 15 "tests/emit/shaders/switches.glsl"
    for (int i = 0; i < 3; i++) {
#line 15 "tests/emit/shaders/switches.glsl"
      if (x > 5.0f) {
#line 15 "tests/emit/shaders/switches.glsl"
        return 9.0f;
#line 15 "tests/emit/shaders/switches.glsl"
      }
#line 15 "tests/emit/shaders/switches.glsl"
    }
#line 15 "tests/emit/shaders/switches.glsl"
    return x;
#line 15 "tests/emit/shaders/switches.glsl"
  }
#line 174 "twin.cpp"

#line 16 "tests/emit/shaders/switches.glsl"
  void nothing(int k) {
#line 16 "tests/emit/shaders/switches.glsl"
    switch (k) {
#line 16 "tests/emit/shaders/switches.glsl"
      case 1:
#line 16 "tests/emit/shaders/switches.glsl"
      {
#line 16 "tests/emit/shaders/switches.glsl"
        {
#line 16 "tests/emit/shaders/switches.glsl"
          return;
#line 16 "tests/emit/shaders/switches.glsl"
        }
#line 16 "tests/emit/shaders/switches.glsl"
      }
#line 16 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
#line 16 "tests/emit/shaders/switches.glsl"
      case 2:
#line 16 "tests/emit/shaders/switches.glsl"
      default:
#line 16 "tests/emit/shaders/switches.glsl"
      {
#line 16 "tests/emit/shaders/switches.glsl"
        break;
#line 16 "tests/emit/shaders/switches.glsl"
      }
#line 16 "tests/emit/shaders/switches.glsl"
    }
#line 16 "tests/emit/shaders/switches.glsl"
  }
#line 208 "twin.cpp"

#line 17 "tests/emit/shaders/switches.glsl"
  int pick(uint u) {
#line 17 "tests/emit/shaders/switches.glsl"
    nothing(int(u));
#line 17 "tests/emit/shaders/switches.glsl"
    switch (u) {
#line 17 "tests/emit/shaders/switches.glsl"
      case 3u:
#line 17 "tests/emit/shaders/switches.glsl"
      {
#line 17 "tests/emit/shaders/switches.glsl"
        return 30;
#line 17 "tests/emit/shaders/switches.glsl"
      }
#line 17 "tests/emit/shaders/switches.glsl"
      [[fallthrough]];
#line 17 "tests/emit/shaders/switches.glsl"
      default:
#line 17 "tests/emit/shaders/switches.glsl"
      {
#line 17 "tests/emit/shaders/switches.glsl"
        return 40;
#line 17 "tests/emit/shaders/switches.glsl"
      }
#line 17 "tests/emit/shaders/switches.glsl"
    }
#line 17 "tests/emit/shaders/switches.glsl"
    return {};
#line 17 "tests/emit/shaders/switches.glsl"
  }
#line 240 "twin.cpp"

#line 18 "tests/emit/shaders/switches.glsl"
  void mainImage(vec4& color, vec2 p) {
    color = vec4(choose(make<int>(p.x)), early(p.x), Float(pick(make<uint>(p.y))), early(p.y));
#line 19 "tests/emit/shaders/switches.glsl"
  }
#line 247 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
