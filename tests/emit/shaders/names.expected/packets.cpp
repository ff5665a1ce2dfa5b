#include "reference/twin/packet_invocation.h"
#undef INFINITY
#undef M_PI
#undef NULL
#undef _Atomic_
#undef _Complex_
#undef assert

namespace shadertwin::glsl::packet {
namespace {

struct private__ {
  Float operator__;
  vec2 friend__;
  friend void set__(Bool m, private__& to, const private__& from) { set__(m, to.operator__, from.operator__); set__(m, to.friend__, from.friend__); }
  friend Bool same__(const private__& a, const private__& b) { return Bool(true) && same__(a.operator__, b.operator__) && same__(a.friend__, b.friend__); }
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float register__{};
  Float M_PI{};
  Float NULL{};
  Float EOF{};
  Float assert{};
  Float errno{};
  Float INFINITY{};
  vec2 uv{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, register__);
    M_PI = 3.0f;
    NULL = 4.0f;
    EOF = 5.0f;
    assert = 6.0f;
    errno = 7.0f;
    INFINITY = 2.0f;
    uv = vec2(3.0f);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 59;

#line 3 "tests/emit/shaders/names.glsl"
  float class__(Bool active, float a) {
#line 3 "tests/emit/shaders/names.glsl"
    return a;
#line 3 "tests/emit/shaders/names.glsl"
  }
#line 56 "twin.cpp"

#line 4 "tests/emit/shaders/names.glsl"
  float delete_(Bool active, float this__) {
#line 4 "tests/emit/shaders/names.glsl"
    return this__ + 1.0f;
#line 4 "tests/emit/shaders/names.glsl"
  }
#line 64 "twin.cpp"

#line 5 "tests/emit/shaders/names.glsl"
  float int__(Bool active, float and_) {
#line 5 "tests/emit/shaders/names.glsl"
    float or_ = and_ * 2.0f;
#line 5 "tests/emit/shaders/names.glsl"
    return or_;
#line 5 "tests/emit/shaders/names.glsl"
  }
#line 74 "twin.cpp"

#line 6 "tests/emit/shaders/names.glsl"
  float fract__(Bool active, float x) {
#line 6 "tests/emit/shaders/names.glsl"
    return x - floor(x);
#line 6 "tests/emit/shaders/names.glsl"
  }
#line 82 "twin.cpp"

#line 7 "tests/emit/shaders/names.glsl"
  Float array_(Bool active, Float std_) {
#line 7 "tests/emit/shaders/names.glsl"
    return std_ * 3.0f;
#line 7 "tests/emit/shaders/names.glsl"
  }
#line 90 "twin.cpp"

#line 8 "tests/emit/shaders/names.glsl"
  float swizzle_(Bool active, float at_) {
#line 8 "tests/emit/shaders/names.glsl"
    return at_ - 1.0f;
#line 8 "tests/emit/shaders/names.glsl"
  }
#line 98 "twin.cpp"

#line 9 "tests/emit/shaders/names.glsl"
  Float _Complex_(Bool active, Float _Atomic_) {
#line 9 "tests/emit/shaders/names.glsl"
    return _Atomic_;
#line 9 "tests/emit/shaders/names.glsl"
  }
#line 106 "twin.cpp"

#line 13 "tests/emit/shaders/names.glsl"
  float map(Bool active, uniform::vec3 p) {
#line 13 "tests/emit/shaders/names.glsl"
    return p.x;
#line 13 "tests/emit/shaders/names.glsl"
  }
#line 114 "twin.cpp"

#line 14 "tests/emit/shaders/names.glsl"
  Float noise(Bool active, Float p) {
#line 14 "tests/emit/shaders/names.glsl"
    return p * 0.5f;
#line 14 "tests/emit/shaders/names.glsl"
  }
#line 122 "twin.cpp"

#line 16 "tests/emit/shaders/names.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 16 "tests/emit/shaders/names.glsl"
    unwritten(active, color);
    Float noise_2 = noise(active, _Complex_(active, p.x));
#line 17 "tests/emit/shaders/names.glsl"
    Float length_2 = length(p * vec2(0.0f, 1.0f));
#line 17 "tests/emit/shaders/names.glsl"
    float mix = 2.0f;
    float char_ = 1.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float signed_ = 2.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float new_ = 3.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float nullptr_ = 4.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float main_ = 5.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float thread_local_ = 6.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float xor_ = 7.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float not_eq_ = 8.0f;
#line 18 "tests/emit/shaders/names.glsl"
    float wchar_t_ = 9.0f;
    Float array__ = array_(active, p.y);
#line 19 "tests/emit/shaders/names.glsl"
    float Shader_ = 2.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float vec = 3.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float glm = 4.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float tmp = 1.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float make_ = 3.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float divide_ = 2.0f;
#line 19 "tests/emit/shaders/names.glsl"
    float lane_ = 4.0f;
    vec2 uv_2 = uv + p;
    {
#line 21 "tests/emit/shaders/names.glsl"
      vec2 uv_3 = uv_2 * 2.0f;
#line 21 "tests/emit/shaders/names.glsl"
      noise_2 = noise_2 + uv_3.x;
#line 21 "tests/emit/shaders/names.glsl"
      Float p_2 = uv_3.y;
#line 21 "tests/emit/shaders/names.glsl"
      noise_2 = noise_2 + p_2;
#line 21 "tests/emit/shaders/names.glsl"
    }
    private__ s = private__{1.0f, vec2(2.0f, 3.0f)};
    set__(active, color, vec4(noise_2 + length_2 + mix, char_ + signed_ * new_ + nullptr_ + main_ + thread_local_ + xor_ + not_eq_ + wchar_t_, array__ + Shader_ + vec + glm + tmp + make_ + divide_ + lane_ + swizzle_(active, delete_(active, int__(active, 1.0f))), M_PI + NULL + EOF + assert + errno + INFINITY + s.friend__.y + s.operator__ + uv_2.y + map(active, uniform::vec3(1.0f)) + class__(active, 2.0f) + fract__(active, 1.25f)));
#line 23 "tests/emit/shaders/names.glsl"
  }
#line 181 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
