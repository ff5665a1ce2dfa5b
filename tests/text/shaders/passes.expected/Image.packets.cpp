#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  array<uniform::vec3, 4> iChannelResolution{};
  sampler2D iChannel0{};
  Int shadertwin_failed{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    shadertwin_failed = -1;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iChannelResolution", iChannelResolution);
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 31;

  void st_assert(Bool active, Bool condition, int kind) {
    if (Bool active_2 = active && !condition; any__(active_2)) {
      set__(active_2, shadertwin_failed, kind);
    }
  }

  void st_assert(Bool active, Bool condition) {
    st_assert(active, condition, 0);
  }

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    if (Bool active_2 = active && (shadertwin_failed >= 0); any__(active_2)) {
      set__(active_2, swizzle<0, 1, 2>(shadertoy_color), vec3(make<Float>(shadertwin_failed == 0 || shadertwin_failed == 3), make<Float>(shadertwin_failed == 1 || shadertwin_failed == 3), make<Float>(shadertwin_failed == 2)));
    }
    set__(active, shadertoy_out_color, vec4(shadertoy_color.xyz(), 1.0f));
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  float wave(Bool active, float t, float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 54 "twin.cpp"

#line 2 "tests/text/shaders/passes/image.glsl"
  void mainImage(Bool active, vec4& c, vec2 p) {
#line 2 "tests/text/shaders/passes/image.glsl"
    unwritten(active, c);
#line 4 "tests/text/shaders/passes/image.glsl"
    array<Float, 3> levels;
#line 4 "tests/text/shaders/passes/image.glsl"
    const Int tmp = make<Int>(p.x) % 3;
#line 4 "tests/text/shaders/passes/image.glsl"
    Float element = at(levels, tmp);
#line 4 "tests/text/shaders/passes/image.glsl"
    element = texture(active, iChannel0, p / vec2(iResolution.xy())).x;
#line 4 "tests/text/shaders/passes/image.glsl"
    put__(active, levels, tmp, element);
    st_assert(active, levels[0] >= 0.0f);
    set__(active, c, vec4(levels[0], levels[1], iChannelResolution[0].xy()));
#line 6 "tests/text/shaders/passes/image.glsl"
  }
#line 74 "twin.cpp"

#line 8 "tests/text/shaders/passes/image.glsl"
  void mainVR(Bool active, vec4& c, uniform::vec2 p, uniform::vec3 origin, uniform::vec3 direction) {
#line 8 "tests/text/shaders/passes/image.glsl"
    set__(active, c, vec4(uniform::vec4(direction, 1.0f)));
#line 8 "tests/text/shaders/passes/image.glsl"
  }
#line 82 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
