#include "reference/twin/invocation.h"
#undef INFINITY
#undef M_PI
#undef NULL
#undef _Atomic_
#undef _Complex_
#undef assert

namespace shadertwin::glsl {
namespace {

struct private__ {
  Float operator__;
  vec2 friend__;
  bool operator==(const private__&) const = default;
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

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(register__);
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
  Float class__(Float a) {
#line 3 "tests/emit/shaders/names.glsl"
    return a;
#line 3 "tests/emit/shaders/names.glsl"
  }
#line 55 "twin.cpp"

#line 4 "tests/emit/shaders/names.glsl"
  Float delete_(Float this__) {
#line 4 "tests/emit/shaders/names.glsl"
    return this__ + 1.0f;
#line 4 "tests/emit/shaders/names.glsl"
  }
#line 63 "twin.cpp"

#line 5 "tests/emit/shaders/names.glsl"
  Float int__(Float and_) {
#line 5 "tests/emit/shaders/names.glsl"
    Float or_ = and_ * 2.0f;
#line 5 "tests/emit/shaders/names.glsl"
    return or_;
#line 5 "tests/emit/shaders/names.glsl"
  }
#line 73 "twin.cpp"

#line 6 "tests/emit/shaders/names.glsl"
  Float fract__(Float x) {
#line 6 "tests/emit/shaders/names.glsl"
    return x - floor(x);
#line 6 "tests/emit/shaders/names.glsl"
  }
#line 81 "twin.cpp"

#line 7 "tests/emit/shaders/names.glsl"
  Float array_(Float std_) {
#line 7 "tests/emit/shaders/names.glsl"
    return std_ * 3.0f;
#line 7 "tests/emit/shaders/names.glsl"
  }
#line 89 "twin.cpp"

#line 8 "tests/emit/shaders/names.glsl"
  Float swizzle_(Float at_) {
#line 8 "tests/emit/shaders/names.glsl"
    return at_ - 1.0f;
#line 8 "tests/emit/shaders/names.glsl"
  }
#line 97 "twin.cpp"

#line 9 "tests/emit/shaders/names.glsl"
  Float _Complex_(Float _Atomic_) {
#line 9 "tests/emit/shaders/names.glsl"
    return _Atomic_;
#line 9 "tests/emit/shaders/names.glsl"
  }
#line 105 "twin.cpp"

#line 13 "tests/emit/shaders/names.glsl"
  Float map(vec3 p) {
#line 13 "tests/emit/shaders/names.glsl"
    return p.x;
#line 13 "tests/emit/shaders/names.glsl"
  }
#line 113 "twin.cpp"

#line 14 "tests/emit/shaders/names.glsl"
  Float noise(Float p) {
#line 14 "tests/emit/shaders/names.glsl"
    return p * 0.5f;
#line 14 "tests/emit/shaders/names.glsl"
  }
#line 121 "twin.cpp"

#line 16 "tests/emit/shaders/names.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 16 "tests/emit/shaders/names.glsl"
    unwritten(color);
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
    Float array__ = array_(p.y);
#line 19 "tests/emit/shaders/names.glsl"
    Float Shader_ = 2.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float vec = 3.0f;
#line 19 "tests/emit/shaders/names.glsl"
    Float glm = 4.0f;
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
    private__ s = private__{1.0f, vec2(2.0f, 3.0f)};
    color = vec4(noise_2 + length_2 + mix, char_ + signed_ * new_ + nullptr_ + main_ + thread_local_ + xor_ + not_eq_ + wchar_t_, array__ + Shader_ + vec + glm + tmp + make_ + divide_ + lane_ + swizzle_(delete_(int__(1.0f))), M_PI + NULL + EOF + assert + errno + INFINITY + s.friend__.y + s.operator__ + uv_2.y + map(vec3(1.0f)) + class__(2.0f) + fract__(1.25f));
#line 23 "tests/emit/shaders/names.glsl"
  }
#line 180 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
