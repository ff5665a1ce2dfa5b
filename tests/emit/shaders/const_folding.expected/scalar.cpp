#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

const Float c = 2.4099998f;
const Float d = 0.47140452f;
const Float e = 0.10000001f;
const array<int, 3> list = array<int, 3>{{5, 10, 2}};
const array<vec4, 6> constant = array<vec4, 6>{{vec4(0.30462098f, 1.2659477f, 0.29145682f, 1.5707964f), vec4(0.9635582f, 0.26749888f, 0.30933625f, 3.1415927f), vec4(0.30452034f, 1.0453385f, 0.29131266f, 0.295673f), vec4(1.3498589f, -1.2039728f, 1.2311444f, -1.7369655f), vec4(0.75643283f, 0.3095196f, 1.8257418f, 0.43051162f), vec4(-0.29000002f, -0.39000002f, 70.01002f, -19.990004f)}};
const Float size = -3.0f;
const Float infinite = uintBitsToFloat(0x7f800000u);
const ivec2 bits = ivec2(1073741824, -1082130432);

struct Shader : Invocation {
  vec4 shadertoy_out_color{};

  void initialise__() {
    unwritten(shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 119;

#line 14 "tests/emit/shaders/const_folding.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 14 "tests/emit/shaders/const_folding.glsl"
    unwritten(color);
#line 17 "tests/emit/shaders/const_folding.glsl"
    array<Float, 5> sizes;
#line 17 "tests/emit/shaders/const_folding.glsl"
    sizes[4] = 2.069f;
    color = vec4(c, d, e, sizes[4]);
    if (p.y > 3.0f) {
#line 19 "tests/emit/shaders/const_folding.glsl"
      color = vec4(-0.08690724f, 0.03160263f, 0.00790066f, 9.313226e-10f);
#line 19 "tests/emit/shaders/const_folding.glsl"
    }
    if (p.y > 6.0f) {
#line 20 "tests/emit/shaders/const_folding.glsl"
      color = vec4(-0.7562058f, -0.96000004f, Float(list[make<int>(p.x) % 3]), 0.38f);
#line 20 "tests/emit/shaders/const_folding.glsl"
    }
    if (p.x > 4.0f && p.x < 11.0f) {
      array<vec4, 6> list_2 = constant;
      color = list_2[make<int>(p.x) % 6];
#line 23 "tests/emit/shaders/const_folding.glsl"
    }
#line 25 "tests/emit/shaders/const_folding.glsl"
    if (p.x > 12.0f) {
#line 25 "tests/emit/shaders/const_folding.glsl"
      color = vec4(3.0f + 0.25f * p.x, size, make<vec2>(p.x < infinite ? bits : ivec2(-1073741824, 1082130432)));
#line 25 "tests/emit/shaders/const_folding.glsl"
    }
#line 25 "tests/emit/shaders/const_folding.glsl"
  }
#line 62 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
