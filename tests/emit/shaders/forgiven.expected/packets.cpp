#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Segment {
  Float shadertwin_length;
  vec2 way;
  friend void set__(Bool m, Segment& to, const Segment& from) { set__(m, to.shadertwin_length, from.shadertwin_length); set__(m, to.way, from.way); }
  friend Bool same__(const Segment& a, const Segment& b) { return Bool(true) && same__(a.shadertwin_length, b.shadertwin_length) && same__(a.way, b.way); }
};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Float shadertwin_step{};
  Float shadertwin_packed{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  float shadertwin_mix(Bool active, float a, float b, float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 38 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  float shadertwin_mix(Bool active, float a, float b, bool c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 46 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec2 shadertwin_mix(Bool active, uniform::vec2 a, uniform::vec2 b, uniform::vec2 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 54 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec2 shadertwin_mix(Bool active, uniform::vec2 a, uniform::vec2 b, float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 62 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec2 shadertwin_mix(Bool active, uniform::vec2 a, uniform::vec2 b, uniform::bvec2 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 70 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec3 shadertwin_mix(Bool active, uniform::vec3 a, uniform::vec3 b, uniform::vec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 78 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec3 shadertwin_mix(Bool active, uniform::vec3 a, uniform::vec3 b, float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 86 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec3 shadertwin_mix(Bool active, uniform::vec3 a, uniform::vec3 b, uniform::bvec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 94 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec4 shadertwin_mix(Bool active, uniform::vec4 a, uniform::vec4 b, uniform::vec4 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 102 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec4 shadertwin_mix(Bool active, uniform::vec4 a, uniform::vec4 b, float c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 110 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  uniform::vec4 shadertwin_mix(Bool active, uniform::vec4 a, uniform::vec4 b, uniform::bvec4 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return mix(a, b, c);
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 118 "twin.cpp"

#line 10 "tests/emit/shaders/forgiven.glsl"
  vec2 shadertwin_mix(Bool active, vec2 a, vec2 b, uniform::vec3 c) {
#line 10 "tests/emit/shaders/forgiven.glsl"
    return a * vec2(c.xy()) + b * c.z;
#line 10 "tests/emit/shaders/forgiven.glsl"
  }
#line 126 "twin.cpp"

#line 11 "tests/emit/shaders/forgiven.glsl"
  vec3 shadertwin_fma(Bool active, uniform::vec3 a, vec3 b, uniform::vec3 shadertwin_unnamed_0) {
#line 11 "tests/emit/shaders/forgiven.glsl"
    return vec3(a) * b;
#line 11 "tests/emit/shaders/forgiven.glsl"
  }
#line 134 "twin.cpp"

#line 12 "tests/emit/shaders/forgiven.glsl"
  Float choose(Bool active, Int k) {
#line 12 "tests/emit/shaders/forgiven.glsl"
    Float result{};
#line 14 "tests/emit/shaders/forgiven.glsl"
    {
#line 14 "tests/emit/shaders/forgiven.glsl"
      const Int selector = k;
#line 14 "tests/emit/shaders/forgiven.glsl"
      Bool active_2 = false;
#line 14 "tests/emit/shaders/forgiven.glsl"
      active_2 = active_2 || (active && (selector == 0));
#line 14 "tests/emit/shaders/forgiven.glsl"
      if (any__(active_2)) {
        set__(active_2, result, 1.0f);
#line 15 "tests/emit/shaders/forgiven.glsl"
        mask_out__(active_2, active);
#line 15 "tests/emit/shaders/forgiven.glsl"
      }
#line 15 "tests/emit/shaders/forgiven.glsl"
      active_2 = active_2 || (active && (selector == 1));
#line 15 "tests/emit/shaders/forgiven.glsl"
      if (any__(active_2)) {
        mask_out__(active_2);
#line 16 "tests/emit/shaders/forgiven.glsl"
      }
#line 16 "tests/emit/shaders/forgiven.glsl"
    }
#line 16 "tests/emit/shaders/forgiven.glsl"
    if (none__(active)) return result;
#line 18 "tests/emit/shaders/forgiven.glsl"
    set__(active, result, shadertwin_step);
#line 18 "tests/emit/shaders/forgiven.glsl"
    return result;
#line 18 "tests/emit/shaders/forgiven.glsl"
  }
#line 172 "twin.cpp"

#line 20 "tests/emit/shaders/forgiven.glsl"
  void mainImage(Bool active, vec4& c, vec2 p) {
#line 20 "tests/emit/shaders/forgiven.glsl"
    unwritten(active, c);
#line 22 "tests/emit/shaders/forgiven.glsl"
    Segment s = Segment{Float(2.0f), p};
    s.shadertwin_length = s.shadertwin_length * (0.0f + shadertwin_step);
    set__(active, c, vec4(shadertwin_mix(active, p, s.way, uniform::vec3(1.0f, 2.0f, 3.0f)), shadertwin_mix(active, 1.0f, 2.0f, 0.5f) * shadertwin_packed, choose(active, make<Int>(p.x)) + s.shadertwin_length));
    set__(active, swizzle<0, 1, 2>(c), c.xyz() + shadertwin_fma(active, uniform::vec3(2.0f, 5.0f, 8.0f), vec3(p, 1.0f), uniform::vec3(0.0f)));
#line 25 "tests/emit/shaders/forgiven.glsl"
  }
#line 185 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
