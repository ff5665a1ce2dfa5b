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
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/endless_discards.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/endless_discards.glsl"
    unwritten(active, color);
    Float sum = 1.0f / (1.0f + p.x);
    if (Bool active_2 = active && (p.x + p.y > 20.0f); any__(active_2)) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
      {
#line 4 "tests/emit/shaders/endless_discards.glsl"
        Bool loop = active_2;
#line 4 "tests/emit/shaders/endless_discards.glsl"
        for (;;) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
          loop = loop && (sum >= 0.0f);
#line 4 "tests/emit/shaders/endless_discards.glsl"
          if (none__(loop)) break;
#line 4 "tests/emit/shaders/endless_discards.glsl"
          Bool active_3 = loop;
#line 4 "tests/emit/shaders/endless_discards.glsl"
          if (Bool active_4 = active_3 && (p.x > 1.0f); any__(active_4)) {
#line 4 "tests/emit/shaders/endless_discards.glsl"
            alive__ = alive__ && !active_4;
#line 4 "tests/emit/shaders/endless_discards.glsl"
            mask_out__(active_4, active_3, loop, active_2, active);
#line 4 "tests/emit/shaders/endless_discards.glsl"
          }
#line 4 "tests/emit/shaders/endless_discards.glsl"
          if (none__(active_3)) continue;
#line 4 "tests/emit/shaders/endless_discards.glsl"
        }
#line 4 "tests/emit/shaders/endless_discards.glsl"
      }
#line 4 "tests/emit/shaders/endless_discards.glsl"
    }
#line 4 "tests/emit/shaders/endless_discards.glsl"
    if (none__(active)) return;
    set__(active, color, vec4(p, sum, 1.0f));
#line 5 "tests/emit/shaders/endless_discards.glsl"
  }
#line 60 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    keep__(alive__, active);
    if (none__(active)) return;
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
