#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec3 iResolution{};
  vec4 color{};

  void initialise__() {
    unwritten(color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 0;

#line 3 "tests/text/shaders/own_output.glsl"
  void main() {
#line 3 "tests/text/shaders/own_output.glsl"
    color = vec4(gl_FragCoord.xy() / iResolution.xy(), 0.0f, 1.0f);
#line 3 "tests/text/shaders/own_output.glsl"
  }
#line 29 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(color)
