#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  uniform::vec3 iResolution{};
  Float n{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, n);
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
  Float next(Bool active) {
#line 7 "tests/emit/shaders/golf.glsl"
    set__(active, n, n + 1.0f);
#line 7 "tests/emit/shaders/golf.glsl"
    return n;
#line 7 "tests/emit/shaders/golf.glsl"
  }
#line 33 "twin.cpp"

#line 9 "tests/emit/shaders/golf.glsl"
  vec4 steps(Bool active, vec2 u) {
#line 12 "tests/emit/shaders/golf.glsl"
    vec4 O;
#line 12 "tests/emit/shaders/golf.glsl"
    Float z;
#line 12 "tests/emit/shaders/golf.glsl"
    Float d;
#line 12 "tests/emit/shaders/golf.glsl"
    {
#line 12 "tests/emit/shaders/golf.glsl"
      float i;
#line 12 "tests/emit/shaders/golf.glsl"
      O = O * i;
#line 12 "tests/emit/shaders/golf.glsl"
      for (; i++ < 9.0f; O = O + (cos(z * 0.4f + vec4(6.0f, 1.0f, 2.0f, 3.0f)) + 1.0f) / (0.1f + d)) {
        d = 0.05f + 0.1f * abs(length(u * 0.1f * make<mat2>(make<uniform::mat2>(cos(i + uniform::vec4(0.0f, 33.0f, 11.0f, 0.0f))))) - z);
#line 13 "tests/emit/shaders/golf.glsl"
        const Float tmp = d;
#line 13 "tests/emit/shaders/golf.glsl"
        z = z + tmp;
#line 13 "tests/emit/shaders/golf.glsl"
      }
#line 13 "tests/emit/shaders/golf.glsl"
    }
    return tanh(O / 20.0f);
#line 14 "tests/emit/shaders/golf.glsl"
  }
#line 63 "twin.cpp"

#line 17 "tests/emit/shaders/golf.glsl"
  vec4 folds(Bool active, vec2 u) {
    vec2 p = u * 0.1f;
#line 18 "tests/emit/shaders/golf.glsl"
    p = p * sign(p.x - 0.5f);
#line 18 "tests/emit/shaders/golf.glsl"
    vec2 C = p;
    p = select__(C.x > 1.0f, p, -p.yx());
#line 19 "tests/emit/shaders/golf.glsl"
    Float d = 0.2f - abs(length(min(p, vec2(0.0f, 1.0f))) - 0.17f);
#line 19 "tests/emit/shaders/golf.glsl"
    float i = 8.0f;
    Float e;
#line 20 "tests/emit/shaders/golf.glsl"
    while (i-- > 0.0f) {
#line 20 "tests/emit/shaders/golf.glsl"
      p = abs(p) - 0.6f;
#line 20 "tests/emit/shaders/golf.glsl"
      e = e + select__(p.x > p.y, p.x, p.y);
#line 20 "tests/emit/shaders/golf.glsl"
    }
    i = 2.0f;
#line 21 "tests/emit/shaders/golf.glsl"
    return vec4(p, d, e + i * 3.0f);
#line 21 "tests/emit/shaders/golf.glsl"
  }
#line 91 "twin.cpp"

#line 24 "tests/emit/shaders/golf.glsl"
  vec4 headers(Bool active, vec2 u) {
#line 27 "tests/emit/shaders/golf.glsl"
    vec4 O;
#line 27 "tests/emit/shaders/golf.glsl"
    float s;
#line 27 "tests/emit/shaders/golf.glsl"
    float g;
#line 27 "tests/emit/shaders/golf.glsl"
    float i;
#line 27 "tests/emit/shaders/golf.glsl"
    for (O = vec4(u, 0.0f, 1.0f) * 0.1f; i < 6.0f; g += 0.3f, s += g, O.z = O.z + s * 0.1f) {
#line 27 "tests/emit/shaders/golf.glsl"
      i++;
#line 27 "tests/emit/shaders/golf.glsl"
    }
    for (vec3 p = vec3(u, 1.0f) * 0.1f; i-- > 0.0f; p = p.yzx() + 0.1f) {
#line 28 "tests/emit/shaders/golf.glsl"
      swizzle<0, 1, 2>(O) = O.xyz() + p * 0.01f;
#line 28 "tests/emit/shaders/golf.glsl"
    }
    for (int j = 0; j++ < 3;) {
#line 29 "tests/emit/shaders/golf.glsl"
      O.x = O.x + 0.5f;
#line 29 "tests/emit/shaders/golf.glsl"
    }
    for (int j = 0; j++ < 3;) {
#line 30 "tests/emit/shaders/golf.glsl"
      O.y = O.y + float(j) * 0.25f;
#line 30 "tests/emit/shaders/golf.glsl"
    }
    int k;
#line 31 "tests/emit/shaders/golf.glsl"
    for (; k < 3; k++) {
#line 33 "tests/emit/shaders/golf.glsl"
      Float a;
#line 33 "tests/emit/shaders/golf.glsl"
      float z;
#line 33 "tests/emit/shaders/golf.glsl"
      for (; z < 1.0f; z += 0.25f) {
#line 33 "tests/emit/shaders/golf.glsl"
        a = a + fract(u.x * z);
#line 33 "tests/emit/shaders/golf.glsl"
      }
      at(O, k) = at(O, k) + a;
#line 34 "tests/emit/shaders/golf.glsl"
    }
#line 36 "tests/emit/shaders/golf.glsl"
    return O;
#line 36 "tests/emit/shaders/golf.glsl"
  }
#line 144 "twin.cpp"

#line 39 "tests/emit/shaders/golf.glsl"
  vec4 constructors(Bool active, vec2 u) {
    vec3 p = vec3(iResolution);
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 d = make<vec3>(u + u - p.xy(), p) / p.x;
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 c = d - d;
#line 40 "tests/emit/shaders/golf.glsl"
    vec3 i = c;
    Int x;
#line 41 "tests/emit/shaders/golf.glsl"
    {
#line 41 "tests/emit/shaders/golf.glsl"
      Bool loop = active;
#line 41 "tests/emit/shaders/golf.glsl"
      for (;; set__(loop, x, x + 1)) {
#line 41 "tests/emit/shaders/golf.glsl"
        loop = loop && (x < 9);
#line 41 "tests/emit/shaders/golf.glsl"
        if (none__(loop)) break;
#line 41 "tests/emit/shaders/golf.glsl"
        Bool active_2 = loop;
        if (Bool active_3 = active_2 && (i.x >= 0.3f); any__(active_3)) {
#line 42 "tests/emit/shaders/golf.glsl"
          mask_out__(active_3, active_2, loop);
#line 42 "tests/emit/shaders/golf.glsl"
        }
#line 42 "tests/emit/shaders/golf.glsl"
        if (none__(active_2)) continue;
        set__(active_2, p, c);
#line 43 "tests/emit/shaders/golf.glsl"
        set__(active_2, i.x, i.x + 0.06f);
#line 43 "tests/emit/shaders/golf.glsl"
        const Float tmp = i.x;
#line 43 "tests/emit/shaders/golf.glsl"
        set__(active_2, p.z, p.z - tmp);
#line 43 "tests/emit/shaders/golf.glsl"
        set__(active_2, c, c + (abs(p.yzx()) + d * 0.1f));
#line 43 "tests/emit/shaders/golf.glsl"
      }
#line 43 "tests/emit/shaders/golf.glsl"
    }
#line 45 "tests/emit/shaders/golf.glsl"
    vec4 O = make<vec4>(u, c);
    swizzle<0, 1>(O) = O.xy() + make<vec2>(u.y, O).yx() * make<Float>(make<Int>(u.x) >> 1 & 1);
    (void)make<vec2>(d);
    for (float a = 0.0f; [&]() -> bool { (void)uniform::vec2(a); return a < 2.0f; }(); (void)make<vec2>(i), a++) {
#line 48 "tests/emit/shaders/golf.glsl"
      (void)uniform::vec3(a);
#line 48 "tests/emit/shaders/golf.glsl"
      O.x = O.x + float(make<int>(a));
#line 48 "tests/emit/shaders/golf.glsl"
    }
    const Bool condition = O.w > 0.5f;
#line 49 "tests/emit/shaders/golf.glsl"
    vec4 tmp_2{};
#line 49 "tests/emit/shaders/golf.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 49 "tests/emit/shaders/golf.glsl"
      set__(active_2, tmp_2, O * next(active_2));
#line 49 "tests/emit/shaders/golf.glsl"
    }
#line 49 "tests/emit/shaders/golf.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 49 "tests/emit/shaders/golf.glsl"
      set__(active_2, tmp_2, O / next(active_2));
#line 49 "tests/emit/shaders/golf.glsl"
    }
#line 49 "tests/emit/shaders/golf.glsl"
    return tmp_2;
#line 49 "tests/emit/shaders/golf.glsl"
  }
#line 218 "twin.cpp"

#line 52 "tests/emit/shaders/golf.glsl"
  void mainImage(Bool active, vec4& O, vec2 I) {
    const Bool condition = I.y < 3.0f;
#line 53 "tests/emit/shaders/golf.glsl"
    vec4 tmp{};
#line 53 "tests/emit/shaders/golf.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 53 "tests/emit/shaders/golf.glsl"
      set__(active_2, tmp, steps(active_2, I));
#line 53 "tests/emit/shaders/golf.glsl"
    }
#line 53 "tests/emit/shaders/golf.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 53 "tests/emit/shaders/golf.glsl"
      const Bool condition_2 = I.y < 5.0f;
#line 53 "tests/emit/shaders/golf.glsl"
      vec4 tmp_2{};
#line 53 "tests/emit/shaders/golf.glsl"
      if (Bool active_3 = active_2 && condition_2; any__(active_3)) {
#line 53 "tests/emit/shaders/golf.glsl"
        set__(active_3, tmp_2, folds(active_3, I));
#line 53 "tests/emit/shaders/golf.glsl"
      }
#line 53 "tests/emit/shaders/golf.glsl"
      if (Bool active_3 = active_2 && !condition_2; any__(active_3)) {
#line 53 "tests/emit/shaders/golf.glsl"
        const Bool condition_3 = I.y < 7.0f;
#line 53 "tests/emit/shaders/golf.glsl"
        vec4 tmp_3{};
#line 53 "tests/emit/shaders/golf.glsl"
        if (Bool active_4 = active_3 && condition_3; any__(active_4)) {
#line 53 "tests/emit/shaders/golf.glsl"
          set__(active_4, tmp_3, headers(active_4, I));
#line 53 "tests/emit/shaders/golf.glsl"
        }
#line 53 "tests/emit/shaders/golf.glsl"
        if (Bool active_4 = active_3 && !condition_3; any__(active_4)) {
#line 53 "tests/emit/shaders/golf.glsl"
          set__(active_4, tmp_3, constructors(active_4, I));
#line 53 "tests/emit/shaders/golf.glsl"
        }
#line 53 "tests/emit/shaders/golf.glsl"
        set__(active_3, tmp_2, tmp_3);
#line 53 "tests/emit/shaders/golf.glsl"
      }
#line 53 "tests/emit/shaders/golf.glsl"
      set__(active_2, tmp, tmp_2);
#line 53 "tests/emit/shaders/golf.glsl"
    }
#line 53 "tests/emit/shaders/golf.glsl"
    set__(active, O, tmp);
#line 53 "tests/emit/shaders/golf.glsl"
  }
#line 273 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
