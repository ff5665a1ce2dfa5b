#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iFrame", iFrame);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/inputs/pattern.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/inputs/pattern.glsl"
    unwritten(color);
    uint h = make<uint>(p.x) * 374761393u + make<uint>(p.y) * 668265263u + uint(iFrame) * 2246822519u;
    h = (h ^ h >> 13) * 1274126177u;
    color = vec4(Float(h & 255u), Float(h >> 8 & 255u), Float(h >> 16 & 255u), Float(h >> 24)) / 255.0f * 4.0f - 1.0f;
#line 5 "tests/emit/shaders/inputs/pattern.glsl"
  }
#line 32 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
