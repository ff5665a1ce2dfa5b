#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

const int Key_A = 65;
const int Key_Enter = 13;

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  sampler2D iKeyboard{};
  Float speed{};

  void initialise__() {
    unwritten(shadertoy_out_color);
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

  bool isKeyDown(int key) {
    return texture(iKeyboard, vec2(Float(key) / 255.0f, 0.125f)).x > 0.0f;
  }

  bool isKeyPressed(int key) {
    return texture(iKeyboard, vec2(Float(key) / 255.0f, 0.375f)).x > 0.0f;
  }

  bool isKeyToggled(int key) {
    return texture(iKeyboard, vec2(Float(key) / 255.0f, 0.625f)).x > 0.0f;
  }

  bool isKeyReleased(int key) {
    return texture(iKeyboard, vec2(Float(key) / 255.0f, 0.875f)).x > 0.0f;
  }

#line 4 "tests/text/shaders/keyboard.glsl"
  void mainImage(vec4& c, vec2 p) {
#line 4 "tests/text/shaders/keyboard.glsl"
    c = vec4(isKeyDown(Key_A) ? speed : 0.0f, Float(isKeyToggled(Key_Enter)), 0.0f, 1.0f);
#line 4 "tests/text/shaders/keyboard.glsl"
  }
#line 50 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)
