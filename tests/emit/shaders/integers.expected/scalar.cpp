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
  static constexpr std::size_t components__ = 26;

#line 2 "tests/emit/shaders/integers.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/integers.glsl"
    unwritten(color);
    int x = make<int>(p.x) - 8;
#line 3 "tests/emit/shaders/integers.glsl"
    int y = make<int>(p.y);
    uint u = uint(make<int>(p.x)) * 2654435769u + uint(y) * 2654435769u;
    u ^= u >> 16;
#line 5 "tests/emit/shaders/integers.glsl"
    u *= 2246822507u;
#line 5 "tests/emit/shaders/integers.glsl"
    u ^= u >> 13;
#line 5 "tests/emit/shaders/integers.glsl"
    u += 2147483648u;
    int wrapped = 2147483647 + x + 8;
    int product = 65537 * (y + 65536);
    ivec3 v = ivec3(x, y, 7) * 3 - ivec3(1);
    swizzle<2, 0>(v) = abs(v.zx());
    v ^= ivec3(5);
#line 10 "tests/emit/shaders/integers.glsl"
    v |= 8;
#line 10 "tests/emit/shaders/integers.glsl"
    v &= -3;
    ivec2 d = divide(ivec2(17, -17), ivec2(y + 1, 3));
    int m = (y + 20) % 7;
    uvec2 q = shift_right(uvec2(u), uvec2(3u, 5u));
    q = shift_left(q, 2u);
    swizzle<1, 0>(q) ^= q;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) |= 1u;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) &= q * 3u;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = shift_left(q.yx(), 1u);
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = shift_right(q.yx(), uvec2(1u, 2u));
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<2, 0>(v) = modulo(v.zx(), 11);
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<0, 2>(v) = divide(v.xz(), 2);
    x <<= 1;
#line 16 "tests/emit/shaders/integers.glsl"
    x >>= 2;
#line 16 "tests/emit/shaders/integers.glsl"
    x++;
#line 16 "tests/emit/shaders/integers.glsl"
    --x;
    bool odd = (y & 1) == 1 != x > 0;
    ivec2 rounded = make<ivec2>(vec2(p.x - 8.0f, p.y) * 1.75f);
    color = vec4(Float(u >> 8), Float(wrapped / 1000), Float(product), Float(v.x + v.y * 16 + v.z * 256));
    if (mod(p.x, 2.0f) > 1.0f) {
      color = vec4(Float(d.x - d.y), Float(m), Float(q.x ^ q.y), Float(rounded.x * 10 + rounded.y) + (odd ? 0.5f : 0.0f));
#line 21 "tests/emit/shaders/integers.glsl"
    }
    if (mod(p.y, 4.0f) > 3.0f) {
#line 22 "tests/emit/shaders/integers.glsl"
      color = vec4(uintBitsToFloat(u >> 9 | 1065353216u), Float(x), Float(int(u)), Float(uint(x)));
#line 22 "tests/emit/shaders/integers.glsl"
    }
#line 22 "tests/emit/shaders/integers.glsl"
  }
#line 83 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
