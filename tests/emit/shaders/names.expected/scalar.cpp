#include "reference/twin/invocation.h"
#undef EOF
#undef INFINITY
#undef M_PI
#undef NULL

namespace shadertwin::glsl {
namespace {

struct private_ {
  Float operator_;
  vec2 friend_;
  bool operator==(const private_&) const = default;
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float register_{};
  Float M_PI_{};
  Float NULL_{};
  Float EOF_{};
  Float assert_{};
  Float errno_{};
  Float INFINITY_{};
  vec2 uv{};

  void initialise() {
    unwritten(shadertoy_out_color);
    unwritten(register_);
    M_PI_ = 3.0f;
    NULL_ = 4.0f;
    EOF_ = 5.0f;
    assert_ = 6.0f;
    errno_ = 7.0f;
    INFINITY_ = 2.0f;
    uv = vec2(3.0f);
  }
  template <class Bind>
  void bind_uniforms(Bind&& bind) {
  }
  static constexpr bool uses_derivatives = false;
  static constexpr bool uses_implicit_lod = false;
  static constexpr bool uses_stop = false;

#line 3 "tests/emit/shaders/names.glsl"
  Float class_(Float a) {
#line 3 "tests/emit/shaders/names.glsl"
    return a;
#line 3 "tests/emit/shaders/names.glsl"
  }
#line 52 "twin.cpp"

#line 4 "tests/emit/shaders/names.glsl"
  Float delete_(Float this_) {
#line 4 "tests/emit/shaders/names.glsl"
    return this_ + 1.0f;
#line 4 "tests/emit/shaders/names.glsl"
  }
#line 60 "twin.cpp"

#line 5 "tests/emit/shaders/names.glsl"
  Float int_(Float and_) {
#line 5 "tests/emit/shaders/names.glsl"
    Float or_ = and_ * 2.0f;
#line 5 "tests/emit/shaders/names.glsl"
    return or_;
#line 5 "tests/emit/shaders/names.glsl"
  }
#line 70 "twin.cpp"

#line 6 "tests/emit/shaders/names.glsl"
  Float fract_(Float x) {
#line 6 "tests/emit/shaders/names.glsl"
    return x - floor(x);
#line 6 "tests/emit/shaders/names.glsl"
  }
#line 78 "twin.cpp"

#line 7 "tests/emit/shaders/names.glsl"
  Float array_(Float std_) {
#line 7 "tests/emit/shaders/names.glsl"
    return std_ * 3.0f;
#line 7 "tests/emit/shaders/names.glsl"
  }
#line 86 "twin.cpp"

#line 8 "tests/emit/shaders/names.glsl"
  Float swizzle_(Float at_) {
#line 8 "tests/emit/shaders/names.glsl"
    return at_ - 1.0f;
#line 8 "tests/emit/shaders/names.glsl"
  }
#line 94 "twin.cpp"

#line 9 "tests/emit/shaders/names.glsl"
  Float _Complex_(Float _Atomic_) {
#line 9 "tests/emit/shaders/names.glsl"
    return _Atomic_;
#line 9 "tests/emit/shaders/names.glsl"
  }
#line 102 "twin.cpp"

#line 13 "tests/emit/shaders/names.glsl"
  Float map(vec3 p) {
#line 13 "tests/emit/shaders/names.glsl"
    return p.x;
#line 13 "tests/emit/shaders/names.glsl"
  }
#line 110 "twin.cpp"

#line 14 "tests/emit/shaders/names.glsl"
  Float noise(Float p) {
#line 14 "tests/emit/shaders/names.glsl"
    return p * 0.5f;
#line 14 "tests/emit/shaders/names.glsl"
  }
#line 118 "twin.cpp"

#line 16 "tests/emit/shaders/names.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 16 "tests/emit/shaders/names.glsl"
    color = vec4(0.0f);
    Float noise_2 = noise(_Complex_(p.x));
#line 17 "tests/emit/shaders/names.glsl"
    Float length_2 = length(p * vec2(0.0f, 1.0f));
#line 17 "tests/emit/shaders/names.glsl"
    Float mix = 2.0f;
    Float char_ = 1.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float signed_ = 2.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float new_ = 3.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float nullptr_ = 4.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float main_ = 5.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float thread_local_ = 6.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float xor_ = 7.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float not_eq_ = 8.0f;
#line 18 "tests/emit/shaders/names.glsl"
    Float wchar_t_ = 9.0f;
    Float array__2 = array_(p.y);
#line 19 "tests/emit/shaders/names.glsl"
    Float Shader_ = 2.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float vec = 3.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float glm_ = 4.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float tmp = 1.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float make_ = 3.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float divide_ = 2.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float lane_ = 4.0f;
    vec2 uv_2 = uv + p;
    {
#line 21 "tests/emit/shaders/names.glsl"
      vec2 uv_3 = uv_2 * 2.0f;
#line 21 "tests/emit/shaders/names.glsl"
      noise_2 += uv_3.x;
#line 21 "tests/emit/shaders/names.glsl"
      Float p_2 = uv_3.y;
#line 21 "tests/emit/shaders/names.glsl"
      noise_2 += p_2;
#line 21 "tests/emit/shaders/names.glsl"
    }
    private_ s = private_{1.0f, vec2(2.0f, 3.0f)};
    color = vec4(noise_2 + length_2 + mix, char_ + signed_ * new_ + nullptr_ + main_ + thread_local_ + xor_ + not_eq_ + wchar_t_, array__2 + Shader_ + vec + glm_ + tmp + make_ + divide_ + lane_ + swizzle_(delete_(int_(1.0f))), M_PI_ + NULL_ + EOF_ + assert_ + errno_ + INFINITY_ + s.friend_.y + s.operator_ + uv_2.y + map(vec3(1.0f)) + class_(2.0f) + fract_(1.25f));
#line 23 "tests/emit/shaders/names.glsl"
  }
#line 177 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
