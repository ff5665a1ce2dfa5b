#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int iFrame{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iFrame", iFrame);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 11;

#line 2 "tests/emit/shaders/inputs/pattern.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 2 "tests/emit/shaders/inputs/pattern.glsl"
    unwritten(active, color);
    Uint h = make<Uint>(p.x) * 374761393u + make<Uint>(p.y) * 668265263u + uint(iFrame) * 2246822519u;
    h = (h ^ h >> 13) * 1274126177u;
    set__(active, color, vec4(make<Float>(h & 255u), make<Float>(h >> 8 & 255u), make<Float>(h >> 16 & 255u), make<Float>(h >> 24)) / 255.0f * 4.0f - 1.0f);
#line 5 "tests/emit/shaders/inputs/pattern.glsl"
  }
#line 32 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
