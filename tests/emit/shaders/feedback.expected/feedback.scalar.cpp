#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};
  sampler2D iChannel0{};
  sampler2D iChannel1{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iFrame", iFrame);
    bind("iChannel0", iChannel0);
    bind("iChannel1", iChannel1);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = true;
  static constexpr std::size_t components__ = 18;

#line 4 "tests/emit/shaders/feedback.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 4 "tests/emit/shaders/feedback.glsl"
    unwritten(color);
    vec4 before = texelFetch(iChannel0, make<ivec2>(p), 0);
#line 5 "tests/emit/shaders/feedback.glsl"
    vec4 other = texelFetch(iChannel1, modulo(make<ivec2>(p.yx()), 8), 0);
    if (iFrame == 1 && p.x < 3.0f) {
#line 6 "tests/emit/shaders/feedback.glsl"
      stop_invocation__();
#line 6 "tests/emit/shaders/feedback.glsl"
    }
    color = before * 0.5f + other + Float(iFrame);
#line 7 "tests/emit/shaders/feedback.glsl"
  }
#line 42 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
