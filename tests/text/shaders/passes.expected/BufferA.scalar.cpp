#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float iTime{};
  sampler2D iChannel0{};
  samplerCube iChannel1{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iTime", iTime);
    bind("iChannel0", iChannel0);
    bind("iChannel1", iChannel1);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 12;

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  Float wave(Float t, Float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 39 "twin.cpp"

#line 3 "tests/text/shaders/passes/buffer_a.glsl"
  void mainImage(vec4& c, vec2 p) {
    c = texelFetch(iChannel0, make<ivec2>(p), 0) + texture(iChannel1, vec3(p, 1.0f)) * wave(iTime, 1.0f);
#line 4 "tests/text/shaders/passes/buffer_a.glsl"
  }
#line 46 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
