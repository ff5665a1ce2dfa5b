#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 33;

#line 2 "tests/emit/shaders/bits.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/bits.glsl"
    unwritten(color);
    Float x = (p.x - 8.0f) * 0.37f;
    uint u = floatBitsToUint(x);
#line 4 "tests/emit/shaders/bits.glsl"
    int i = floatBitsToInt(-x);
    Float back = uintBitsToFloat(u ^ 2147483648u) + intBitsToFloat(i);
    uint h = packHalf2x16(vec2(x, p.y));
#line 6 "tests/emit/shaders/bits.glsl"
    uint s = packSnorm2x16(vec2(x, 0.3f));
#line 6 "tests/emit/shaders/bits.glsl"
    uint n = packUnorm2x16(vec2(x, 0.7f));
    vec2 q = unpackHalf2x16(h) + unpackSnorm2x16(s) + unpackUnorm2x16(n);
    Float whole;
#line 8 "tests/emit/shaders/bits.glsl"
    Float part = modf(x, whole);
    vec2 two;
#line 9 "tests/emit/shaders/bits.glsl"
    vec2 parts = modf(vec2(x, p.y * 0.3f), two);
#line 9 "tests/emit/shaders/bits.glsl"
    vec3 wholes;
#line 9 "tests/emit/shaders/bits.glsl"
    swizzle<2, 0>(wholes) = two;
    vec3 pieces = modf(vec3(x), wholes);
    Float inf = 1.0f / (p.x - 0.5f);
#line 11 "tests/emit/shaders/bits.glsl"
    Float nan = sqrt(-p.x);
    color = vec4(Float(u >> 8), back, q);
    if (p.y > 2.0f) {
#line 13 "tests/emit/shaders/bits.glsl"
      color = vec4(whole, part, parts.y + wholes.z, Float(h >> 4));
#line 13 "tests/emit/shaders/bits.glsl"
    }
    if (p.y > 4.0f) {
#line 14 "tests/emit/shaders/bits.glsl"
      color = vec4(round(x * 2.0f), roundEven(x * 2.0f), trunc(x), floor(x) + ceil(x) * 16.0f);
#line 14 "tests/emit/shaders/bits.glsl"
    }
    if (p.y > 6.0f) {
#line 15 "tests/emit/shaders/bits.glsl"
      color = vec4(isnan(nan) ? 1.0f : 0.0f, isinf(inf) ? 1.0f : 0.0f, sign(x), fract(x) + mod(x, 0.75f) + step(0.5f, x));
#line 15 "tests/emit/shaders/bits.glsl"
    }
#line 15 "tests/emit/shaders/bits.glsl"
  }
#line 68 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
