#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

const float c = 2.4099998f;
const float d = 0.47140452f;
const float e = 0.10000001f;
const array<int, 3> list = array<int, 3>{{5, 10, 2}};
const array<uniform::vec4, 6> constant = array<uniform::vec4, 6>{{uniform::vec4(0.30462098f, 1.2659477f, 0.29145682f, 1.5707964f), uniform::vec4(0.9635582f, 0.26749888f, 0.30933625f, 3.1415927f), uniform::vec4(0.30452034f, 1.0453385f, 0.29131266f, 0.295673f), uniform::vec4(1.3498589f, -1.2039728f, 1.2311444f, -1.7369655f), uniform::vec4(0.75643283f, 0.3095196f, 1.8257418f, 0.43051162f), uniform::vec4(-0.29000002f, -0.39000002f, 70.01002f, -19.990004f)}};
const float size = -3.0f;
const float infinite = uintBitsToFloat(0x7f800000u);
const uniform::ivec2 bits = uniform::ivec2(1073741824, -1082130432);

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
  static constexpr std::size_t components__ = 119;

#line 14 "tests/emit/shaders/const_folding.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 14 "tests/emit/shaders/const_folding.glsl"
    unwritten(active, color);
#line 17 "tests/emit/shaders/const_folding.glsl"
    array<Float, 5> sizes;
#line 17 "tests/emit/shaders/const_folding.glsl"
    sizes[4] = 2.069f;
    set__(active, color, vec4(c, d, e, sizes[4]));
    if (Bool active_2 = active && (p.y > 3.0f); any__(active_2)) {
#line 19 "tests/emit/shaders/const_folding.glsl"
      set__(active_2, color, vec4(-0.08690724f, 0.03160263f, 0.00790066f, 9.313226e-10f));
#line 19 "tests/emit/shaders/const_folding.glsl"
    }
    if (Bool active_2 = active && (p.y > 6.0f); any__(active_2)) {
#line 20 "tests/emit/shaders/const_folding.glsl"
      set__(active_2, color, vec4(-0.7562058f, -0.96000004f, make<Float>(at(list, make<Int>(p.x) % 3)), 0.38f));
#line 20 "tests/emit/shaders/const_folding.glsl"
    }
    if (Bool active_2 = active && (p.x > 4.0f && p.x < 11.0f); any__(active_2)) {
      array<vec4, 6> list_2 = spread__(constant);
      set__(active_2, color, at(list_2, make<Int>(p.x) % 6));
#line 23 "tests/emit/shaders/const_folding.glsl"
    }
#line 25 "tests/emit/shaders/const_folding.glsl"
    if (Bool active_2 = active && (p.x > 12.0f); any__(active_2)) {
#line 25 "tests/emit/shaders/const_folding.glsl"
      set__(active_2, color, vec4(3.0f + 0.25f * p.x, size, make<vec2>(select__(p.x < infinite, ivec2(bits), ivec2(-1073741824, 1082130432)))));
#line 25 "tests/emit/shaders/const_folding.glsl"
    }
#line 25 "tests/emit/shaders/const_folding.glsl"
  }
#line 62 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
