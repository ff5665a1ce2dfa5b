#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Pair {
  Float a;
  Float b;
  bool operator==(const Pair&) const = default;
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uint state{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(state);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 51;

#line 3 "tests/emit/shaders/evaluation_order.glsl"
  uint rnd() {
#line 3 "tests/emit/shaders/evaluation_order.glsl"
    state = state * 747796405u + 2891336453u;
#line 3 "tests/emit/shaders/evaluation_order.glsl"
    return state >> 9;
#line 3 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 37 "twin.cpp"

#line 4 "tests/emit/shaders/evaluation_order.glsl"
  Float f() {
#line 4 "tests/emit/shaders/evaluation_order.glsl"
    return Float(rnd() & 255u);
#line 4 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 45 "twin.cpp"

#line 5 "tests/emit/shaders/evaluation_order.glsl"
  Float g(Float a, Float b, Float c) {
#line 5 "tests/emit/shaders/evaluation_order.glsl"
    return a - b * 2.0f + c * 4.0f;
#line 5 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 53 "twin.cpp"

#line 7 "tests/emit/shaders/evaluation_order.glsl"
  Float pick(int i) {
#line 7 "tests/emit/shaders/evaluation_order.glsl"
    return i > 1 ? f() : 1.0f;
#line 7 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 61 "twin.cpp"

#line 9 "tests/emit/shaders/evaluation_order.glsl"
  vec4 late(vec2 q) {
    Float x = q.x;
#line 10 "tests/emit/shaders/evaluation_order.glsl"
    Float y = q.x;
#line 10 "tests/emit/shaders/evaluation_order.glsl"
    Float z = q.y;
    vec2 p = q;
#line 11 "tests/emit/shaders/evaluation_order.glsl"
    vec2 r = q;
    const vec2 tmp = p += 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_2 = x++;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_3 = y -= 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    const vec2 tmp_4 = r += 1.0f;
#line 12 "tests/emit/shaders/evaluation_order.glsl"
    vec4 sum = vec4(p, tmp) + vec4(x, tmp_2, max(y, tmp_3), dot(r, tmp_4));
    const Float tmp_5 = length(p -= 0.3f);
#line 13 "tests/emit/shaders/evaluation_order.glsl"
    sum.x += p.x - tmp_5;
    const vec2 tmp_6 = r *= 2.0f;
#line 14 "tests/emit/shaders/evaluation_order.glsl"
    r = r + tmp_6;
    int i = make<int>(q.x);
    const Float tmp_7 = Float(i++);
#line 16 "tests/emit/shaders/evaluation_order.glsl"
    vec2 k = vec2(Float(i), tmp_7);
    sum.z += k.x * 3.0f + k.y;
    const Float tmp_8 = z = 9.0f;
#line 18 "tests/emit/shaders/evaluation_order.glsl"
    return sum + vec4(r, z, tmp_8);
#line 18 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 98 "twin.cpp"

#line 20 "tests/emit/shaders/evaluation_order.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 20 "tests/emit/shaders/evaluation_order.glsl"
    unwritten(color);
    state = make<uint>(p.x) + 256u * make<uint>(p.y);
    const Float tmp = f();
#line 22 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_2 = f();
#line 22 "tests/emit/shaders/evaluation_order.glsl"
    vec3 v = vec3(tmp, tmp_2, f());
    const Float tmp_3 = f();
#line 23 "tests/emit/shaders/evaluation_order.glsl"
    Float a = tmp_3 - f();
    const Float tmp_4 = f();
#line 24 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_5 = f();
#line 24 "tests/emit/shaders/evaluation_order.glsl"
    Float b = g(tmp_4, tmp_5, f());
    const Float tmp_6 = f();
#line 25 "tests/emit/shaders/evaluation_order.glsl"
    Pair q = Pair{tmp_6, f()};
    const Float tmp_7 = f();
#line 26 "tests/emit/shaders/evaluation_order.glsl"
    array<Float, 2> list = array<Float, 2>{{tmp_7, f()}};
    int i = 0;
    const Float tmp_8 = Float(i++);
#line 28 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_9 = tmp_8 + Float(i++) * 8.0f;
#line 28 "tests/emit/shaders/evaluation_order.glsl"
    Float c = tmp_9 + Float(++i) * 64.0f;
    Float d = f() > 100.0f && f() > 50.0f || f() < 9.0f ? f() : -f();
    const Float tmp_10 = pick(i);
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_11 = f() * 2.0f;
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    const Float tmp_12 = f();
#line 30 "tests/emit/shaders/evaluation_order.glsl"
    Float e = tmp_10 + (tmp_11 + (tmp_12 - f()));
    for (int k = make<int>(f()) & 3; k < 5 && f() < 250.0f; k += 1 + int(rnd() & 1u)) {
#line 31 "tests/emit/shaders/evaluation_order.glsl"
      e += Float(k);
#line 31 "tests/emit/shaders/evaluation_order.glsl"
    }
    while (f() < 200.0f) {
#line 32 "tests/emit/shaders/evaluation_order.glsl"
      e += 0.5f;
#line 32 "tests/emit/shaders/evaluation_order.glsl"
    }
    Float x = 1.0f;
    x += 1.0f;
#line 34 "tests/emit/shaders/evaluation_order.glsl"
    Float y = x * 3.0f;
    color = vec4(v.x + 256.0f * v.y, v.z + 0.5f * a, b + q.a - q.b * 0.5f, list[0] - list[1] + c);
    if (mod(p.x, 2.0f) > 1.0f) {
#line 36 "tests/emit/shaders/evaluation_order.glsl"
      color = vec4(d, e, y, f());
#line 36 "tests/emit/shaders/evaluation_order.glsl"
    }
    if (p.y > 8.0f) {
#line 37 "tests/emit/shaders/evaluation_order.glsl"
      color = late(p);
#line 37 "tests/emit/shaders/evaluation_order.glsl"
    }
#line 37 "tests/emit/shaders/evaluation_order.glsl"
  }
#line 165 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
