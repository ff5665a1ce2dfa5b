#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  array<vec3, 4> iChannelResolution{};
  sampler2D iChannel0{};
  int shadertwin_failed{};

  void initialise__() {
    unwritten(shadertoy_out_color);
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

  void st_assert(bool condition, int kind) {
    if (!condition) {
      shadertwin_failed = kind;
    }
  }

  void st_assert(bool condition) {
    st_assert(condition, 0);
  }

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    if (shadertwin_failed >= 0) {
      swizzle<0, 1, 2>(shadertoy_color) = vec3(Float(shadertwin_failed == 0 || shadertwin_failed == 3), Float(shadertwin_failed == 1 || shadertwin_failed == 3), Float(shadertwin_failed == 2));
    }
    shadertoy_out_color = vec4(shadertoy_color.xyz(), 1.0f);
  }

#line 3 "tests/text/shaders/passes/common.glsl"
  Float wave(Float t, Float hertz) {
#line 3 "tests/text/shaders/passes/common.glsl"
    return sin(6.2831855f * hertz * t);
#line 3 "tests/text/shaders/passes/common.glsl"
  }
#line 54 "twin.cpp"

#line 2 "tests/text/shaders/passes/image.glsl"
  void mainImage(vec4& c, vec2 p) {
#line 2 "tests/text/shaders/passes/image.glsl"
    unwritten(c);
#line 4 "tests/text/shaders/passes/image.glsl"
    array<Float, 3> levels;
#line 4 "tests/text/shaders/passes/image.glsl"
    levels[make<int>(p.x) % 3] = texture(iChannel0, p / iResolution.xy()).x;
    st_assert(levels[0] >= 0.0f);
    c = vec4(levels[0], levels[1], iChannelResolution[0].xy());
#line 6 "tests/text/shaders/passes/image.glsl"
  }
#line 68 "twin.cpp"

#line 8 "tests/text/shaders/passes/image.glsl"
  void mainVR(vec4& c, vec2 p, vec3 origin, vec3 direction) {
#line 8 "tests/text/shaders/passes/image.glsl"
    c = vec4(direction, 1.0f);
#line 8 "tests/text/shaders/passes/image.glsl"
  }
#line 76 "twin.cpp"

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
