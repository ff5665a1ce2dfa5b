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
  static constexpr std::size_t components__ = 33;

#line 2 "tests/emit/shaders/bits.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/bits.glsl"
    unwritten(active, color);
    Float x = (p.x - 8.0f) * 0.37f;
    Uint u = floatBitsToUint(x);
#line 4 "tests/emit/shaders/bits.glsl"
    Int i = floatBitsToInt(-x);
    Float back = uintBitsToFloat(u ^ 2147483648u) + intBitsToFloat(i);
    Uint h = packHalf2x16(vec2(x, p.y));
#line 6 "tests/emit/shaders/bits.glsl"
    Uint s = packSnorm2x16(vec2(x, 0.3f));
#line 6 "tests/emit/shaders/bits.glsl"
    Uint n = packUnorm2x16(vec2(x, 0.7f));
    vec2 q = unpackHalf2x16(h) + unpackSnorm2x16(s) + unpackUnorm2x16(n);
    Float whole;
#line 8 "tests/emit/shaders/bits.glsl"
    Float whole_2;
#line 8 "tests/emit/shaders/bits.glsl"
    const Float tmp = modf(Float(x), whole_2);
#line 8 "tests/emit/shaders/bits.glsl"
    whole = whole_2;
#line 8 "tests/emit/shaders/bits.glsl"
    Float part = tmp;
    vec2 two;
#line 9 "tests/emit/shaders/bits.glsl"
    vec2 whole_3;
#line 9 "tests/emit/shaders/bits.glsl"
    const vec2 tmp_2 = modf(vec2(vec2(x, p.y * 0.3f)), whole_3);
#line 9 "tests/emit/shaders/bits.glsl"
    two = whole_3;
#line 9 "tests/emit/shaders/bits.glsl"
    vec2 parts = tmp_2;
#line 9 "tests/emit/shaders/bits.glsl"
    vec3 wholes;
#line 9 "tests/emit/shaders/bits.glsl"
    swizzle<2, 0>(wholes) = two;
    vec3 whole_4;
#line 10 "tests/emit/shaders/bits.glsl"
    const vec3 tmp_3 = modf(vec3(vec3(x)), whole_4);
#line 10 "tests/emit/shaders/bits.glsl"
    wholes = whole_4;
#line 10 "tests/emit/shaders/bits.glsl"
    vec3 pieces = tmp_3;
    Float inf = 1.0f / (p.x - 0.5f);
#line 11 "tests/emit/shaders/bits.glsl"
    Float nan = sqrt(-p.x);
    set__(active, color, vec4(make<Float>(u >> 8), back, q));
    if (Bool active_2 = active && (p.y > 2.0f); any__(active_2)) {
#line 13 "tests/emit/shaders/bits.glsl"
      set__(active_2, color, vec4(whole, part, parts.y + wholes.z, make<Float>(h >> 4)));
#line 13 "tests/emit/shaders/bits.glsl"
    }
    if (Bool active_2 = active && (p.y > 4.0f); any__(active_2)) {
#line 14 "tests/emit/shaders/bits.glsl"
      set__(active_2, color, vec4(round(x * 2.0f), roundEven(x * 2.0f), trunc(x), floor(x) + ceil(x) * 16.0f));
#line 14 "tests/emit/shaders/bits.glsl"
    }
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 15 "tests/emit/shaders/bits.glsl"
      set__(active_2, color, vec4(select__(isnan(nan), Float(1.0f), Float(0.0f)), select__(isinf(inf), Float(1.0f), Float(0.0f)), sign(x), fract(x) + mod(x, Float(0.75f)) + step(Float(0.5f), x)));
#line 15 "tests/emit/shaders/bits.glsl"
    }
#line 15 "tests/emit/shaders/bits.glsl"
  }
#line 86 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
