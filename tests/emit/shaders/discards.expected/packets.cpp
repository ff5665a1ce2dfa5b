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
  static constexpr std::size_t components__ = 13;

#line 2 "tests/emit/shaders/discards.glsl"
  Float check(Bool active, vec2 p) {
#line 2 "tests/emit/shaders/discards.glsl"
    if (Bool active_2 = active && (p.x > 10.0f); any__(active_2)) {
#line 2 "tests/emit/shaders/discards.glsl"
      alive__ = alive__ && !active_2;
#line 2 "tests/emit/shaders/discards.glsl"
      mask_out__(active_2, active);
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    if (none__(active)) return {};
#line 2 "tests/emit/shaders/discards.glsl"
    {
#line 2 "tests/emit/shaders/discards.glsl"
      Bool loop = active;
#line 2 "tests/emit/shaders/discards.glsl"
      int i = 0;
#line 2 "tests/emit/shaders/discards.glsl"
      for (;; i++) {
#line 2 "tests/emit/shaders/discards.glsl"
        if (none__(loop)) break;
#line 2 "tests/emit/shaders/discards.glsl"
        Bool active_2 = loop;
#line 2 "tests/emit/shaders/discards.glsl"
        if (Bool active_3 = active_2 && (float(i) > p.y); any__(active_3)) {
#line 2 "tests/emit/shaders/discards.glsl"
          mask_out__(active_3, active_2, loop);
#line 2 "tests/emit/shaders/discards.glsl"
        }
#line 2 "tests/emit/shaders/discards.glsl"
        if (none__(active_2)) continue;
#line 2 "tests/emit/shaders/discards.glsl"
        if (i == 6) {
#line 2 "tests/emit/shaders/discards.glsl"
          alive__ = alive__ && !active_2;
#line 2 "tests/emit/shaders/discards.glsl"
          mask_out__(active_2, loop, active);
#line 2 "tests/emit/shaders/discards.glsl"
        }
#line 2 "tests/emit/shaders/discards.glsl"
        if (none__(active_2)) continue;
#line 2 "tests/emit/shaders/discards.glsl"
      }
#line 2 "tests/emit/shaders/discards.glsl"
    }
#line 2 "tests/emit/shaders/discards.glsl"
    if (none__(active)) return {};
#line 2 "tests/emit/shaders/discards.glsl"
    return p.x;
#line 2 "tests/emit/shaders/discards.glsl"
  }
#line 73 "twin.cpp"

#line 3 "tests/emit/shaders/discards.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 3 "tests/emit/shaders/discards.glsl"
    unwritten(active, color);
    if (Bool active_2 = active && (mod(p.x, Float(4.0f)) < 1.0f && p.y < 4.0f); any__(active_2)) {
#line 4 "tests/emit/shaders/discards.glsl"
      alive__ = alive__ && !active_2;
#line 4 "tests/emit/shaders/discards.glsl"
      mask_out__(active_2, active);
#line 4 "tests/emit/shaders/discards.glsl"
    }
#line 4 "tests/emit/shaders/discards.glsl"
    if (none__(active)) return;
    const Float tmp = check(active, p);
#line 5 "tests/emit/shaders/discards.glsl"
    keep__(alive__, active);
#line 5 "tests/emit/shaders/discards.glsl"
    set__(active, color, vec4(tmp, p.y, 1.0f, 1.0f));
#line 5 "tests/emit/shaders/discards.glsl"
    if (none__(active)) return;
#line 5 "tests/emit/shaders/discards.glsl"
  }
#line 97 "twin.cpp"

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
