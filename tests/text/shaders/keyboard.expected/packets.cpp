#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

const int Key_A = 65;
const int Key_Enter = 13;

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  sampler2D iKeyboard{};
  float speed{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
    bind("iKeyboard", iKeyboard);
    bind("speed", speed);
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = true;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 112;

  Bool isKeyDown(Bool active, int key) {
    return texture(active, iKeyboard, uniform::vec2(float(key) / 255.0f, 0.125f)).x > 0.0f;
  }

  Bool isKeyPressed(Bool active, int key) {
    return texture(active, iKeyboard, uniform::vec2(float(key) / 255.0f, 0.375f)).x > 0.0f;
  }

  Bool isKeyToggled(Bool active, int key) {
    return texture(active, iKeyboard, uniform::vec2(float(key) / 255.0f, 0.625f)).x > 0.0f;
  }

  Bool isKeyReleased(Bool active, int key) {
    return texture(active, iKeyboard, uniform::vec2(float(key) / 255.0f, 0.875f)).x > 0.0f;
  }

#line 4 "tests/text/shaders/keyboard.glsl"
  void mainImage(Bool active, vec4& c, vec2 p) {
#line 4 "tests/text/shaders/keyboard.glsl"
    set__(active, c, vec4(select__(isKeyDown(active, Key_A), Float(speed), Float(0.0f)), make<Float>(isKeyToggled(active, Key_Enter)), 0.0f, 1.0f));
#line 4 "tests/text/shaders/keyboard.glsl"
  }
#line 50 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)
