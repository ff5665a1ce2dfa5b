#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  Float iTime{};
  sampler2D iChannel0{};
  vec2 unused{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(unused);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
    bind("iTime", iTime);
    bind("iChannel0", iChannel0);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 2;

#line 4 "tests/text/shaders/legacy_names.glsl"
  Float level() {
#line 4 "tests/text/shaders/legacy_names.glsl"
    return texture(iChannel0, gl_FragCoord.xy() / iResolution.xy()).x + iTime;
#line 4 "tests/text/shaders/legacy_names.glsl"
  }
#line 35 "twin.cpp"

#line 5 "tests/text/shaders/legacy_names.glsl"
  void main() {
#line 5 "tests/text/shaders/legacy_names.glsl"
    shadertoy_out_color = vec4(clamp(level(), 0.0f, 1.0f));
#line 5 "tests/text/shaders/legacy_names.glsl"
  }
#line 43 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
