#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  uniform::mat2 r(Bool active, float a) {
#line 4 "tests/emit/shaders/uv_tricks.glsl"
    return uniform::mat2(0.8f, -0.6f, 0.6f, 0.8f) * a;
#line 4 "tests/emit/shaders/uv_tricks.glsl"
  }
#line 29 "twin.cpp"

#line 5 "tests/emit/shaders/uv_tricks.glsl"
  void mainImage(Bool active, vec4& O, vec2 U) {
#line 5 "tests/emit/shaders/uv_tricks.glsl"
    unwritten(active, O);
#line 7 "tests/emit/shaders/uv_tricks.glsl"
    vec2 u = (U + U - vec2(iResolution.xy())) / iResolution.y;
#line 7 "tests/emit/shaders/uv_tricks.glsl"
    vec2 v = u * 0.0f;
    set__(active, O, O * 0.0f);
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    float i = 0.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    Float d = 1.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    Float z = 0.0f;
#line 8 "tests/emit/shaders/uv_tricks.glsl"
    vec3 p = vec3(0.0f);
    vec3 q;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
    for (set__(active, O, vec4(0.0f)); i++ < 9.0f; set__(active, O, O + 0.1f / max(d, Float(0.01f)))) {
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      p = z * normalize(vec3(u, 1.0f));
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      p.z = p.z - 2.0f;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      d = abs(length(p) - 1.0f) * 0.5f + 0.01f;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      const Float tmp = d;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      z = z + tmp;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
      q = p;
#line 9 "tests/emit/shaders/uv_tricks.glsl"
    }
    for (int k = 0; k < 3; k++, u = u * make<mat2>(r(active, 1.1f)), v = v + u) {
#line 10 "tests/emit/shaders/uv_tricks.glsl"
    }
    int n = 7;
#line 11 "tests/emit/shaders/uv_tricks.glsl"
    n = ((n & 1) == 1) ? n * 3 + 1 : n / 2;
#line 11 "tests/emit/shaders/uv_tricks.glsl"
    n -= 2;
    v = v * 0.25f;
#line 12 "tests/emit/shaders/uv_tricks.glsl"
    const vec2 tmp_2 = v;
#line 12 "tests/emit/shaders/uv_tricks.glsl"
    set__(active, swizzle<0, 1>(O), O.xy() + tmp_2);
#line 12 "tests/emit/shaders/uv_tricks.glsl"
    set__(active, O.z, float(n) + smoothstep(Float(0.1f), Float(0.9f), select__(u.x > 0.0f, u.x, -u.x)));
    set__(active, O, abs(O));
#line 13 "tests/emit/shaders/uv_tricks.glsl"
    set__(active, O.w, 1.0f - select__(U.x < 5.0f, Float(0.5f), Float(0.25f)));
#line 13 "tests/emit/shaders/uv_tricks.glsl"
    set__(active, O, select__(O.x > 3.0f, O.yxzw(), O));
#line 13 "tests/emit/shaders/uv_tricks.glsl"
  }
#line 87 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
