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
  static constexpr std::size_t components__ = 37;

#line 2 "tests/emit/shaders/vectors.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/vectors.glsl"
    unwritten(color);
    vec4 v = vec4(p, p.yx() * 0.5f);
    swizzle<3, 2>(v) = v.xy();
    swizzle<0, 1, 2>(v) = v.zyx();
    swizzle<0, 1>(v) += vec2(1.0f, 2.0f);
    swizzle<2, 1>(v) *= 2.0f;
    swizzle<2, 1>(v) = v.xx();
    v.y++;
#line 9 "tests/emit/shaders/vectors.glsl"
    swizzle<0, 2>(v) -= 1.0f;
#line 9 "tests/emit/shaders/vectors.glsl"
    ++v.w;
    vec3 a = v.xyz() / 4.0f + 1.0f;
#line 10 "tests/emit/shaders/vectors.glsl"
    vec3 b = 2.0f - a;
#line 10 "tests/emit/shaders/vectors.glsl"
    vec3 c = -a * b;
    c -= 0.5f;
#line 11 "tests/emit/shaders/vectors.glsl"
    c /= vec3(1.0f, 2.0f, 4.0f);
#line 11 "tests/emit/shaders/vectors.glsl"
    c *= 3.0f;
    bvec3 less = lessThan(a, b);
#line 12 "tests/emit/shaders/vectors.glsl"
    bvec3 more = greaterThanEqual(b, c);
    bool every = all(not_(less));
#line 13 "tests/emit/shaders/vectors.glsl"
    bool some = any(more);
#line 13 "tests/emit/shaders/vectors.glsl"
    bool same = a == b;
#line 13 "tests/emit/shaders/vectors.glsl"
    bool other = a.xy() != b.xy();
    int i = make<int>(p.x) % 3;
    at(a, i) = 9.0f;
#line 15 "tests/emit/shaders/vectors.glsl"
    at(b, 2 - i) += 1.0f;
    vec2 t = p.x > 4.0f ? a.zy() : b.xx();
    Float s = at(vec3(1.0f, 2.0f, 3.0f), i);
    v.x = v.y = t.x;
    color = vec4(a.x + b.y + c.z, t.x - t.y, Float(every) + 2.0f * Float(some) + 4.0f * Float(same) + 8.0f * Float(other), v.x + v.z + s);
    if (p.y > 4.0f) {
#line 20 "tests/emit/shaders/vectors.glsl"
      color = vec4(Float(equal(a, b).x ? 1 : 2), Float(notEqual(make<ivec2>(make<ivec3>(a)), make<ivec2>(make<ivec3>(b))).y ? 3 : 4), mix(a, b, less).x, v.w);
#line 20 "tests/emit/shaders/vectors.glsl"
    }
#line 20 "tests/emit/shaders/vectors.glsl"
  }
#line 71 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
