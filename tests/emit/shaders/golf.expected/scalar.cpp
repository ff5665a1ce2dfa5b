#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  vec3 iResolution{};
  Float n{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(n);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iResolution", iResolution);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 66;

#line 7 "tests/emit/shaders/golf.glsl"
  Float next() {
#line 7 "tests/emit/shaders/golf.glsl"
    return n += 1.0f;
#line 7 "tests/emit/shaders/golf.glsl"
  }
#line 31 "twin.cpp"

#line 9 "tests/emit/shaders/golf.glsl"
  vec4 steps(vec2 u) {
#line 12 "tests/emit/shaders/golf.glsl"
    vec4 O;
#line 12 "tests/emit/shaders/golf.glsl"
    Float z;
#line 12 "tests/emit/shaders/golf.glsl"
    Float d;
#line 12 "tests/emit/shaders/golf.glsl"
    {
#line 12 "tests/emit/shaders/golf.glsl"
      Float i;
#line 12 "tests/emit/shaders/golf.glsl"
      O *= i;
#line 12 "tests/emit/shaders/golf.glsl"
      for (; i++ < 9.0f; O += (cos(z * 0.4f + vec4(6.0f, 1.0f, 2.0f, 3.0f)) + 1.0f) / (0.1f + d)) {
        z += d = 0.05f + 0.1f * abs(length(u * 0.1f * make<mat2>(cos(i + vec4(0.0f, 33.0f, 11.0f, 0.0f)))) - z);
#line 13 "tests/emit/shaders/golf.glsl"
      }
#line 13 "tests/emit/shaders/golf.glsl"
    }
    return tanh(O / 20.0f);
#line 14 "tests/emit/shaders/golf.glsl"
  }
#line 57 "twin.cpp"

#line 17 "tests/emit/shaders/golf.glsl"
  vec4 folds(vec2 u) {
    vec2 p = u * 0.1f;
#line 18 "tests/emit/shaders/golf.glsl"
    vec2 C = p *= sign(p.x - 0.5f);
    Float d = 0.2f - abs(length(min(p = C.x > 1.0f ? p : -p.yx(), vec2(0.0f, 1.0f))) - 0.17f);
#line 19 "tests/emit/shaders/golf.glsl"
    Float i = 8.0f;
    Float e;
#line 20 "tests/emit/shaders/golf.glsl"
    while (i-- > 0.0f) {
#line 20 "tests/emit/shaders/golf.glsl"
      p = abs(p) - 0.6f;
#line 20 "tests/emit/shaders/golf.glsl"
      e += p.x > p.y ? p.x : p.y;
#line 20 "tests/emit/shaders/golf.glsl"
    }
    i = 2.0f;
#line 21 "tests/emit/shaders/golf.glsl"
    return vec4(p, d, e + i * 3.0f);
#line 21 "tests/emit/shaders/golf.glsl"
  }
#line 81 "twin.cpp"

#line 24 "tests/emit/shaders/golf.glsl"
  vec4 headers(vec2 u) {
#line 27 "tests/emit/shaders/golf.glsl"
    vec4 O;
#line 27 "tests/emit/shaders/golf.glsl"
    Float s;
#line 27 "tests/emit/shaders/golf.glsl"
    Float g;
#line 27 "tests/emit/shaders/golf.glsl"
    Float i;
#line 27 "tests/emit/shaders/golf.glsl"
    for (O = vec4(u, 0.0f, 1.0f) * 0.1f; i < 6.0f; g += 0.3f, s += g, O.z += s * 0.1f) {
#line 27 "tests/emit/shaders/golf.glsl"
      i++;
#line 27 "tests/emit/shaders/golf.glsl"
    }
    for (vec3 p = vec3(u, 1.0f) * 0.1f; i-- > 0.0f; p = p.yzx() + 0.1f) {
#line 28 "tests/emit/shaders/golf.glsl"
      swizzle<0, 1, 2>(O) += p * 0.01f;
#line 28 "tests/emit/shaders/golf.glsl"
    }
    for (int j = 0; j++ < 3;) {
#line 29 "tests/emit/shaders/golf.glsl"
      O.x += 0.5f;
#line 29 "tests/emit/shaders/golf.glsl"
    }
    for (int j = 0; j++ < 3;) {
#line 30 "tests/emit/shaders/golf.glsl"
      O.y += Float(j) * 0.25f;
#line 30 "tests/emit/shaders/golf.glsl"
    }
    int k;
#line 31 "tests/emit/shaders/golf.glsl"
    for (; k < 3; k++) {
#line 33 "tests/emit/shaders/golf.glsl"
      Float a;
#line 33 "tests/emit/shaders/golf.glsl"
      Float z;
#line 33 "tests/emit/shaders/golf.glsl"
      for (; z < 1.0f; z += 0.25f) {
#line 33 "tests/emit/shaders/golf.glsl"
        a += fract(u.x * z);
#line 33 "tests/emit/shaders/golf.glsl"
      }
      at(O, k) += a;
#line 34 "tests/emit/shaders/golf.glsl"
    }
#line 36 "tests/emit/shaders/golf.glsl"
    return O;
#line 36 "tests/emit/shaders/golf.glsl"
  }
#line 134 "twin.cpp"

#line 39 "tests/emit/shaders/golf.glsl"
  vec4 constructors(vec2 u) {
    vec3 p = iResolution;
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 d = make<vec3>(u + u - p.xy(), p) / p.x;
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 c = d - d;
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 i = c;
    int x;
#line 41 "tests/emit/shaders/golf.glsl"
    for (; x < 9; ++x) {
      if (i.x >= 0.3f) {
#line 42 "tests/emit/shaders/golf.glsl"
        break;
#line 42 "tests/emit/shaders/golf.glsl"
      }
      p = c;
#line 43 "tests/emit/shaders/golf.glsl"
      p.z -= i.x += 0.06f;
#line 43 "tests/emit/shaders/golf.glsl"
      c += abs(p.yzx()) + d * 0.1f;
#line 43 "tests/emit/shaders/golf.glsl"
    }
#line 45 "tests/emit/shaders/golf.glsl"
    vec4 O = make<vec4>(u, c);
    swizzle<0, 1>(O) += make<vec2>(u.y, O).yx() * Float(make<int>(u.x) >> 1 & 1);
    (void)make<vec2>(d);
    for (Float a = 0.0f; [&]() -> bool { (void)vec2(a); return a < 2.0f; }(); (void)make<vec2>(i), a++) {
#line 48 "tests/emit/shaders/golf.glsl"
      (void)vec3(a);
#line 48 "tests/emit/shaders/golf.glsl"
      O.x += Float(make<int>(a));
#line 48 "tests/emit/shaders/golf.glsl"
    }
    return O.w > 0.5f ? O * next() : O / next();
#line 49 "tests/emit/shaders/golf.glsl"
  }
#line 174 "twin.cpp"

#line 52 "tests/emit/shaders/golf.glsl"
  void mainImage(vec4& O, vec2 I) {
    O = I.y < 3.0f ? steps(I) : I.y < 5.0f ? folds(I) : I.y < 7.0f ? headers(I) : constructors(I);
#line 53 "tests/emit/shaders/golf.glsl"
  }
#line 181 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
