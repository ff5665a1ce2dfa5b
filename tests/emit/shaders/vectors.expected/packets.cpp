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
  static constexpr std::size_t components__ = 37;

#line 2 "tests/emit/shaders/vectors.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/vectors.glsl"
    unwritten(active, color);
    vec4 v = vec4(p, p.yx() * 0.5f);
    swizzle<3, 2>(v) = v.xy();
    swizzle<0, 1, 2>(v) = v.zyx();
    swizzle<0, 1>(v) = v.xy() + vec2(1.0f, 2.0f);
    swizzle<2, 1>(v) = v.zy() * 2.0f;
    swizzle<2, 1>(v) = v.xx();
    v.y = v.y + 1.0f;
#line 9 "tests/emit/shaders/vectors.glsl"
    swizzle<0, 2>(v) = v.xz() - 1.0f;
#line 9 "tests/emit/shaders/vectors.glsl"
    v.w = v.w + 1.0f;
    vec3 a = v.xyz() / 4.0f + 1.0f;
#line 10 "tests/emit/shaders/vectors.glsl"
    vec3 b = 2.0f - a;
#line 10 "tests/emit/shaders/vectors.glsl"
    vec3 c = -a * b;
    c = c - 0.5f;
#line 11 "tests/emit/shaders/vectors.glsl"
    c = c / vec3(1.0f, 2.0f, 4.0f);
#line 11 "tests/emit/shaders/vectors.glsl"
    c = c * 3.0f;
    bvec3 less = lessThan(a, b);
#line 12 "tests/emit/shaders/vectors.glsl"
    bvec3 more = greaterThanEqual(b, c);
    Bool every = all(not_(less));
#line 13 "tests/emit/shaders/vectors.glsl"
    Bool some = any(more);
#line 13 "tests/emit/shaders/vectors.glsl"
    Bool same = same__(a, b);
#line 13 "tests/emit/shaders/vectors.glsl"
    Bool other = !same__(a.xy(), b.xy());
    Int i = make<Int>(p.x) % 3;
    const Int tmp = i;
#line 15 "tests/emit/shaders/vectors.glsl"
    Float element = at(a, tmp);
#line 15 "tests/emit/shaders/vectors.glsl"
    element = 9.0f;
#line 15 "tests/emit/shaders/vectors.glsl"
    put__(active, a, tmp, element);
#line 15 "tests/emit/shaders/vectors.glsl"
    const Int tmp_2 = 2 - i;
#line 15 "tests/emit/shaders/vectors.glsl"
    Float element_2 = at(b, tmp_2);
#line 15 "tests/emit/shaders/vectors.glsl"
    element_2 = element_2 + 1.0f;
#line 15 "tests/emit/shaders/vectors.glsl"
    put__(active, b, tmp_2, element_2);
    vec2 t = select__(p.x > 4.0f, a.zy(), b.xx());
    Float s = at(uniform::vec3(1.0f, 2.0f, 3.0f), i);
    v.y = t.x;
#line 18 "tests/emit/shaders/vectors.glsl"
    v.x = v.y;
    set__(active, color, vec4(a.x + b.y + c.z, t.x - t.y, make<Float>(every) + 2.0f * make<Float>(some) + 4.0f * make<Float>(same) + 8.0f * make<Float>(other), v.x + v.z + s));
    if (Bool active_2 = active && (p.y > 4.0f); any__(active_2)) {
#line 20 "tests/emit/shaders/vectors.glsl"
      set__(active_2, color, vec4(make<Float>(select__(equal(a, b).x, Int(1), Int(2))), make<Float>(select__(notEqual(make<ivec2>(make<ivec3>(a)), make<ivec2>(make<ivec3>(b))).y, Int(3), Int(4))), mix(a, b, less).x, v.w));
#line 20 "tests/emit/shaders/vectors.glsl"
    }
#line 20 "tests/emit/shaders/vectors.glsl"
  }
#line 85 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
