#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Segment {
  Float shadertwin_length;
  vec2 way;
  bool operator==(const Segment&) const = default;
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float shadertwin_step{};
  Float shadertwin_packed{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    shadertwin_step = 0.25f;
    shadertwin_packed = 2.0f;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 125;

#line 10 "tests/emit/shaders/forgiven.glsl"
  Float shadertwin_mix(Float a, Float b, Float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 37 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  Float shadertwin_mix(Float a, Float b, bool c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 45 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec2 shadertwin_mix(vec2 a, vec2 b, vec2 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 53 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec2 shadertwin_mix(vec2 a, vec2 b, Float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 61 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec2 shadertwin_mix(vec2 a, vec2 b, bvec2 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 69 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec3 shadertwin_mix(vec3 a, vec3 b, vec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 77 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec3 shadertwin_mix(vec3 a, vec3 b, Float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 85 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec3 shadertwin_mix(vec3 a, vec3 b, bvec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 93 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec4 shadertwin_mix(vec4 a, vec4 b, vec4 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 101 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec4 shadertwin_mix(vec4 a, vec4 b, Float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 109 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec4 shadertwin_mix(vec4 a, vec4 b, bvec4 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 117 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec2 shadertwin_mix(vec2 a, vec2 b, vec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return a * c.xy() + b * c.z;
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 125 "twin.cpp"

#line 11 "tests/emit/shaders/forgiven.glsl"
  vec3 shadertwin_fma(vec3 a, vec3 b, vec3 shadertwin_unnamed_0) {
#line 11 "tests/emit/shaders/forgiven.glsl"
    return a * b;
#line 11 "tests/emit/shaders/forgiven.glsl"
  }
#line 133 "twin.cpp"

#line 12 "tests/emit/shaders/forgiven.glsl"
  Float choose(int k) {
#line 14 "tests/emit/shaders/forgiven.glsl"
    switch (k) {
      case 0:
#line 15 "tests/emit/shaders/forgiven.glsl"
      {
#line 15 "tests/emit/shaders/forgiven.glsl"
        return 1.0f;
#line 15 "tests/emit/shaders/forgiven.glsl"
      }
#line 15 "tests/emit/shaders/forgiven.glsl"
      [[fallthrough]];
      case 1:
#line 16 "tests/emit/shaders/forgiven.glsl"
      {
#line 16 "tests/emit/shaders/forgiven.glsl"
        break;
#line 16 "tests/emit/shaders/forgiven.glsl"
      }
#line 16 "tests/emit/shaders/forgiven.glsl"
    }
#line 18 "tests/emit/shaders/forgiven.glsl"
    return shadertwin_step;
#line 18 "tests/emit/shaders/forgiven.glsl"
  }
#line 161 "twin.cpp"

#line 20 "tests/emit/shaders/forgiven.glsl"
  void mainImage(vec4& c, vec2 p) {
#line 20 "tests/emit/shaders/forgiven.glsl"
    unwritten(c);
#line 22 "tests/emit/shaders/forgiven.glsl"
    Segment s = Segment{2.0f, p};
    s.shadertwin_length *= 0.0f + shadertwin_step;
    c = vec4(shadertwin_mix(p, s.way, vec3(1.0f, 2.0f, 3.0f)), shadertwin_mix(1.0f, 2.0f, 0.5f) * shadertwin_packed, choose(make<int>(p.x)) + s.shadertwin_length);
    swizzle<0, 1, 2>(c) += shadertwin_fma(vec3(2.0f, 5.0f, 8.0f), vec3(p, 1.0f), vec3(0.0f));
#line 25 "tests/emit/shaders/forgiven.glsl"
  }
#line 174 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
