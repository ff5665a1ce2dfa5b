#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int k{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    k = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 44;

#line 3 "tests/emit/shaders/side_effects.glsl"
  int next() {
#line 3 "tests/emit/shaders/side_effects.glsl"
    return k++;
#line 3 "tests/emit/shaders/side_effects.glsl"
  }
#line 29 "twin.cpp"

#line 4 "tests/emit/shaders/side_effects.glsl"
  Float take(array<Float, 4>& list, int i) {
#line 4 "tests/emit/shaders/side_effects.glsl"
    list[i] += 1.0f;
#line 4 "tests/emit/shaders/side_effects.glsl"
    return list[i];
#line 4 "tests/emit/shaders/side_effects.glsl"
  }
#line 39 "twin.cpp"

#line 5 "tests/emit/shaders/side_effects.glsl"
  Float both(Float& a, Float& b) {
#line 5 "tests/emit/shaders/side_effects.glsl"
    Float t = a;
#line 5 "tests/emit/shaders/side_effects.glsl"
    a = b;
#line 5 "tests/emit/shaders/side_effects.glsl"
    b = t;
#line 5 "tests/emit/shaders/side_effects.glsl"
    return a - b;
#line 5 "tests/emit/shaders/side_effects.glsl"
  }
#line 53 "twin.cpp"

#line 6 "tests/emit/shaders/side_effects.glsl"
  vec3 sample_(uint& s) {
#line 6 "tests/emit/shaders/side_effects.glsl"
    s = s * 1664525u + 1013904223u;
#line 6 "tests/emit/shaders/side_effects.glsl"
    return vec3(Float(s >> 8), Float(s >> 16), Float(s >> 24)) / 256.0f;
#line 6 "tests/emit/shaders/side_effects.glsl"
  }
#line 63 "twin.cpp"

#line 7 "tests/emit/shaders/side_effects.glsl"
  bool more(int& n) {
#line 7 "tests/emit/shaders/side_effects.glsl"
    return --n > 0;
#line 7 "tests/emit/shaders/side_effects.glsl"
  }
#line 71 "twin.cpp"

#line 8 "tests/emit/shaders/side_effects.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 8 "tests/emit/shaders/side_effects.glsl"
    unwritten(color);
    array<Float, 4> list = array<Float, 4>{{p.x, 1.0f, 2.0f, 3.0f}};
    const int tmp = next();
#line 10 "tests/emit/shaders/side_effects.glsl"
    list[tmp] += 5.0f;
    const int tmp_2 = next();
#line 11 "tests/emit/shaders/side_effects.glsl"
    list[tmp_2] = list[next()] * 2.0f;
    const Float tmp_3 = take(list, 3);
#line 12 "tests/emit/shaders/side_effects.glsl"
    const Float tmp_4 = tmp_3 * take(list, 3);
#line 12 "tests/emit/shaders/side_effects.glsl"
    Float t = tmp_4 + take(list, k & 3);
    Float tmp_5 = list[0];
#line 13 "tests/emit/shaders/side_effects.glsl"
    Float tmp_6 = list[1];
#line 13 "tests/emit/shaders/side_effects.glsl"
    const Float tmp_7 = both(tmp_5, tmp_6);
#line 13 "tests/emit/shaders/side_effects.glsl"
    list[0] = tmp_5;
#line 13 "tests/emit/shaders/side_effects.glsl"
    list[1] = tmp_6;
#line 13 "tests/emit/shaders/side_effects.glsl"
    Float u = tmp_7;
    uint s = make<uint>(p.x) * 17u + make<uint>(p.y);
    const vec3 tmp_8 = sample_(s);
#line 15 "tests/emit/shaders/side_effects.glsl"
    const vec3 tmp_9 = tmp_8 + sample_(s) * 2.0f;
#line 15 "tests/emit/shaders/side_effects.glsl"
    const vec3 tmp_10 = sample_(s);
#line 15 "tests/emit/shaders/side_effects.glsl"
    vec3 v = tmp_9 - cross(tmp_10, sample_(s));
    vec2 w = p;
    const int tmp_11 = next() & 1;
#line 17 "tests/emit/shaders/side_effects.glsl"
    at(w, tmp_11) *= 3.0f;
    int n = 5;
#line 18 "tests/emit/shaders/side_effects.glsl"
    Float sum = 0.0f;
    while (more(n)) {
#line 19 "tests/emit/shaders/side_effects.glsl"
      sum += Float(n);
#line 19 "tests/emit/shaders/side_effects.glsl"
    }
    do {
#line 20 "tests/emit/shaders/side_effects.glsl"
      sum *= 1.5f;
#line 20 "tests/emit/shaders/side_effects.glsl"
    } while (more(n) || next() < 8);
    for (int i = next(); more(i); sum += Float(i), next()) {
#line 21 "tests/emit/shaders/side_effects.glsl"
      if (sum > 100.0f) {
#line 21 "tests/emit/shaders/side_effects.glsl"
        break;
#line 21 "tests/emit/shaders/side_effects.glsl"
      }
#line 21 "tests/emit/shaders/side_effects.glsl"
    }
    mat2 m = mat2(1.0f, 0.0f, 0.0f, 1.0f);
#line 22 "tests/emit/shaders/side_effects.glsl"
    const int tmp_12 = next() & 1;
#line 22 "tests/emit/shaders/side_effects.glsl"
    at(m, tmp_12) += vec2(sum, Float(k));
    color = vec4(t + list[0] * 0.5f, u + v.x, v.y + w.x + m[0].y, sum + w.y * 0.125f + Float(k) + m[1].x);
#line 23 "tests/emit/shaders/side_effects.glsl"
  }
#line 142 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
