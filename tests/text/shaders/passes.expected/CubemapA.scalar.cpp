#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  int shadertwin_face{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("shadertwin_face", shadertwin_face);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 23;

  void main() {
    vec2 st = 2.0f * gl_FragCoord.xy() / iResolution.xy() - 1.0f;
    vec3 shadertwin_ray = shadertwin_face == 0 ? vec3(1.0f, -st.y, -st.x) : shadertwin_face == 1 ? vec3(-1.0f, -st.y, st.x) : shadertwin_face == 2 ? vec3(st.x, 1.0f, st.y) : shadertwin_face == 3 ? vec3(st.x, -1.0f, -st.y) : shadertwin_face == 4 ? vec3(st.x, -st.y, 1.0f) : vec3(-st.x, -st.y, -1.0f);
    vec4 shadertoy_color = vec4(0.0f);
    mainCubemap(shadertoy_color, gl_FragCoord.xy(), vec3(0.0f), normalize(shadertwin_ray));
    shadertoy_out_color = vec4(unpackHalf2x16(packHalf2x16(shadertoy_color.xy())), unpackHalf2x16(packHalf2x16(shadertoy_color.zw())));
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  Float wave(Float t, Float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 39 "twin.cpp"

#line 1 "tests/text/shaders/passes/cubemap_a.glsl"
  void mainCubemap(vec4& c, vec2 p, vec3 origin, vec3 direction) {
#line 1 "tests/text/shaders/passes/cubemap_a.glsl"
    c = vec4(direction, wave(p.x, 1.0f));
#line 1 "tests/text/shaders/passes/cubemap_a.glsl"
  }
#line 47 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
