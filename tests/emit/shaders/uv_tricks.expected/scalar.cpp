#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 26;

#line 4 "tests/emit/shaders/uv_tricks.glsl"
  mat2 r(Float a) {
#line 4 "tests/emit/shaders/uv_tricks.glsl"
    return mat2(0.8f, -0.6f, 0.6f, 0.8f) * a;
#line 4 "tests/emit/shaders/uv_tricks.glsl"
  }
#line 29 "twin.cpp"

#line 5 "tests/emit/shaders/uv_tricks.glsl"
  void mainImage(vec4& O, vec2 U) {
#line 5 "tests/emit/shaders/uv_tricks.glsl"
    unwritten(O);
#line 7 "tests/emit/shaders/uv_tricks.glsl"
    vec2 u = (U + U - iResolution.xy()) / iResolution.y;
#line 7 "tests/emit/shaders/uv_tricks.glsl"
    vec2 v = u * 0.0f;
    O *= 0.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    Float i = 0.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    Float d = 1.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    Float z = 0.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    vec3 p = vec3(0.0f);
    vec3 q;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
    for (O = vec4(0.0f); i++ < 9.0f; O += 0.1f / max(d, 0.01f)) {
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      p = z * normalize(vec3(u, 1.0f));
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      p.z -= 2.0f;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      z += d = abs(length(p) - 1.0f) * 0.5f + 0.01f;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      q = p;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
    }
    for (int k = 0; k < 3; k++, u = u * r(1.1f), v += u) {
#line 10 "tests/emit/shaders/uv_tricks.glsl"
    }
    int n = 7;
#line 11 "tests/emit/shaders/uv_tricks.glsl"
    n = (n & 1) == 1 ? n * 3 + 1 : n / 2;
#line 11 "tests/emit/shaders/uv_tricks.glsl"
    n -= 2;
    swizzle<0, 1>(O) += v *= 0.25f;
#line 12 "tests/emit/shaders/uv_tricks.glsl"
    O.z = Float(n) + smoothstep(0.1f, 0.9f, u.x > 0.0f ? u.x : -u.x);
    O = abs(O);
#line 13 "tests/emit/shaders/uv_tricks.glsl"
    O.w = 1.0f - (U.x < 5.0f ? 0.5f : 0.25f);
#line 13 "tests/emit/shaders/uv_tricks.glsl"
    O = O.x > 3.0f ? O.yxzw() : O;
#line 13 "tests/emit/shaders/uv_tricks.glsl"
  }
#line 79 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
