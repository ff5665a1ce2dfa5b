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
  static constexpr std::size_t components__ = 14;

#line 2 "tests/emit/shaders/special_calls.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/special_calls.glsl"
    unwritten(active, color);
    vec2 uv = p / vec2(iResolution.yx());
    Float x = sqrt(p.x / 7.0f) - p.y / iResolution.x;
#line 4 "tests/emit/shaders/special_calls.glsl"
    Float y = p.y / iResolution.y;
    set__(active, color, vec4(mix_strict(x, y, Float(0.3f)), mix_strict(x, Float(1.0f), y), mix_strict(vec2(x, y), uv, Float(0.7f)).y, mix(uv, vec2(y, x), x).x));
    if (Bool active_2 = active && (p.y > 3.0f); any__(active_2)) {
#line 6 "tests/emit/shaders/special_calls.glsl"
      const Float tmp = y + x;
#line 6 "tests/emit/shaders/special_calls.glsl"
      set__(active_2, color, vec4(y * y, (tmp * tmp) * (tmp * tmp), exp2(x), (uv * uv).y));
#line 6 "tests/emit/shaders/special_calls.glsl"
    }
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 7 "tests/emit/shaders/special_calls.glsl"
      set__(active_2, color, vec4(min(-x * 0.0f, Float(0.0f)), max(uv, vec2(0.5f)).x, y, pow(abs(x), Float(1.3f))));
#line 7 "tests/emit/shaders/special_calls.glsl"
    }
#line 7 "tests/emit/shaders/special_calls.glsl"
  }
#line 46 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
