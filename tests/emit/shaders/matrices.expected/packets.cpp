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
  static constexpr std::size_t components__ = 116;

#line 2 "tests/emit/shaders/matrices.glsl"
  mat3 rotation(Bool active, Float a) {
#line 2 "tests/emit/shaders/matrices.glsl"
    Float c = 0.5f + a;
#line 2 "tests/emit/shaders/matrices.glsl"
    float s = 0.25f;
#line 2 "tests/emit/shaders/matrices.glsl"
    return make<mat3>(c, -s, 0.0f, s, c, 0.0f, 0.0f, 0.0f, 1.0f);
#line 2 "tests/emit/shaders/matrices.glsl"
  }
#line 31 "twin.cpp"

#line 3 "tests/emit/shaders/matrices.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 3 "tests/emit/shaders/matrices.glsl"
    unwritten(active, color);
    mat2 m = make<mat2>(1.0f, 2.0f, p.x, p.y);
    m = m * 2.0f;
#line 5 "tests/emit/shaders/matrices.glsl"
    m = m + 1.0f;
#line 5 "tests/emit/shaders/matrices.glsl"
    m[1] = m[1] - vec2(0.5f);
#line 5 "tests/emit/shaders/matrices.glsl"
    m[0].y = 4.0f;
#line 5 "tests/emit/shaders/matrices.glsl"
    m = m - make<mat2>(uniform::mat2(1.0f, 0.0f, 0.0f, 1.0f));
    vec2 v = p;
#line 6 "tests/emit/shaders/matrices.glsl"
    v = v * m;
#line 6 "tests/emit/shaders/matrices.glsl"
    v = m * v;
    mat3 r = rotation(active, p.x / 8.0f);
    mat3 rr = r * r;
#line 8 "tests/emit/shaders/matrices.glsl"
    rr = rr * r;
    vec3 w = vec3(p, 1.0f);
#line 9 "tests/emit/shaders/matrices.glsl"
    w = w * r;
#line 9 "tests/emit/shaders/matrices.glsl"
    swizzle<0, 1>(w) = w.xy() * m;
    mat2x3 n = make<mat2x3>(p.x, 1.0f, 2.0f, p.y, 3.0f, 4.0f);
    mat3x2 nt = transpose(n);
    vec3 nv = n * p;
#line 12 "tests/emit/shaders/matrices.glsl"
    vec2 vn = nv * n;
#line 12 "tests/emit/shaders/matrices.glsl"
    mat2 nn = nt * n;
    mat4 big = make<mat4>(make<mat2>(m));
#line 13 "tests/emit/shaders/matrices.glsl"
    big[3] = vec4(w, 1.0f);
#line 13 "tests/emit/shaders/matrices.glsl"
    mat3 small = make<mat3>(big);
#line 13 "tests/emit/shaders/matrices.glsl"
    mat2 from = make<mat2>(uniform::vec2(1.0f, 2.0f), p);
    mat2 mixed = make<mat2>(p.x, uniform::vec2(1.0f, 2.0f), 3.0f);
#line 14 "tests/emit/shaders/matrices.glsl"
    mat2 product = matrixCompMult(m, from);
#line 14 "tests/emit/shaders/matrices.glsl"
    mat2 outer = outerProduct(p, vec2(1.0f, 2.0f));
    mat2 quotient = m / 2.0f;
#line 15 "tests/emit/shaders/matrices.glsl"
    mat2 same = m;
#line 15 "tests/emit/shaders/matrices.glsl"
    same = same + 1.0f;
    Int i = make<Int>(p.x) % 3;
    Float det = determinant(make<mat2>(2.0f, 1.0f, p.x, 3.0f));
    uniform::mat2 inv = uniform::mat2(0.5f, -0.0f, -0.0f, 0.25f);
    set__(active, color, vec4(v, w.x + w.y, at(rr, i).x));
    if (Bool active_2 = active && (p.y > 2.0f); any__(active_2)) {
#line 20 "tests/emit/shaders/matrices.glsl"
      set__(active_2, color, vec4(nv.x, vn.y, nn[1].x, at(small, i).z));
#line 20 "tests/emit/shaders/matrices.glsl"
    }
    if (Bool active_2 = active && (p.y > 4.0f); any__(active_2)) {
#line 21 "tests/emit/shaders/matrices.glsl"
      set__(active_2, color, vec4(mixed[1].x, product[0].y, outer[1].y, quotient[0].x + select__(same__(m, same), Float(1.0f), Float(0.0f))));
#line 21 "tests/emit/shaders/matrices.glsl"
    }
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 22 "tests/emit/shaders/matrices.glsl"
      set__(active_2, color, vec4(det, inv[1].y, -m[0].x, (-m + same)[0].x));
#line 22 "tests/emit/shaders/matrices.glsl"
    }
#line 22 "tests/emit/shaders/matrices.glsl"
  }
#line 106 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
