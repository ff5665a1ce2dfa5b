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
  static constexpr std::size_t components__ = 26;

#line 2 "tests/emit/shaders/integers.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/integers.glsl"
    unwritten(active, color);
    Int x = make<Int>(p.x) - 8;
#line 3 "tests/emit/shaders/integers.glsl"
    Int y = make<Int>(p.y);
    Uint u = make<Uint>(make<Int>(p.x)) * 2654435769u + make<Uint>(y) * 2654435769u;
    u = u ^ u >> 16;
#line 5 "tests/emit/shaders/integers.glsl"
    u = u * 2246822507u;
#line 5 "tests/emit/shaders/integers.glsl"
    u = u ^ u >> 13;
#line 5 "tests/emit/shaders/integers.glsl"
    u = u + 2147483648u;
    Int wrapped = 2147483647 + x + 8;
    Int product = 65537 * (y + 65536);
    ivec3 v = ivec3(x, y, 7) * 3 - ivec3(1);
    swizzle<2, 0>(v) = abs(v.zx());
    v = v ^ ivec3(5);
#line 10 "tests/emit/shaders/integers.glsl"
    v = v | 8;
#line 10 "tests/emit/shaders/integers.glsl"
    v = v & -3;
    ivec2 d = divide(ivec2(17, -17), ivec2(y + 1, 3));
    Int m = (y + 20) % 7;
    uvec2 q = shift_right(uvec2(u), uvec2(3u, 5u));
    q = shift_left(q, Uint(2u));
    swizzle<1, 0>(q) = q.yx() ^ q;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = q.yx() | 1u;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = q.yx() & q * 3u;
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = shift_left(q.yx(), Uint(1u));
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<1, 0>(q) = shift_right(q.yx(), uvec2(1u, 2u));
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<2, 0>(v) = modulo(v.zx(), Int(11));
#line 15 "tests/emit/shaders/integers.glsl"
    swizzle<0, 2>(v) = divide(v.xz(), Int(2));
    x = x << 1;
#line 16 "tests/emit/shaders/integers.glsl"
    x = x >> 2;
#line 16 "tests/emit/shaders/integers.glsl"
    x = x + 1;
#line 16 "tests/emit/shaders/integers.glsl"
    x = x - 1;
    Bool odd = (y & 1) == 1 != x > 0;
    ivec2 rounded = make<ivec2>(vec2(p.x - 8.0f, p.y) * 1.75f);
    set__(active, color, vec4(make<Float>(u >> 8), make<Float>(wrapped / 1000), make<Float>(product), make<Float>(v.x + v.y * 16 + v.z * 256)));
    if (Bool active_2 = active && (mod(p.x, Float(2.0f)) > 1.0f); any__(active_2)) {
      set__(active_2, color, vec4(make<Float>(d.x - d.y), make<Float>(m), make<Float>(q.x ^ q.y), make<Float>(rounded.x * 10 + rounded.y) + select__(odd, Float(0.5f), Float(0.0f))));
#line 21 "tests/emit/shaders/integers.glsl"
    }
    if (Bool active_2 = active && (mod(p.y, Float(4.0f)) > 3.0f); any__(active_2)) {
#line 22 "tests/emit/shaders/integers.glsl"
      set__(active_2, color, vec4(uintBitsToFloat(u >> 9 | 1065353216u), make<Float>(x), make<Float>(make<Int>(u)), make<Float>(make<Uint>(x))));
#line 22 "tests/emit/shaders/integers.glsl"
    }
#line 22 "tests/emit/shaders/integers.glsl"
  }
#line 83 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
