// Shaders written for GLSL Sandbox, The Book of Shaders, glslViewer and their like, on every player. Each
// paints green where the values are its host's.
#include "host/text/load.h"
#include "tests/twin/every_player.h"

namespace shadertwin {
namespace {

class OtherHosts : public OnEveryPlayer {
 protected:
  // What the shader paints at 1.5 s in frame 3, 8x4 pixels, with the mouse held at 2, 1.
  void expect_green(const std::string& name, const std::string& text, int frames = 1) const {
    SCOPED_TRACE(name);
    const Project project = load_project(folder.write(name + ".frag", text));
    for (const OtherUniform& uniform : project.passes.back().other_uniforms)
      EXPECT_TRUE(uniform.set) << uniform.name;
    const auto player = play(project);
    for (int i = 0; i < frames; ++i) {
      Frame now = frame(i + 3, 8, 4);
      now.time = 1.5;
      now.time_delta = 0.25;
      now.date = {2024, 0, 31, 100.5F};
      now.mouse = {2, 1, 2, -1};
      player->render(now);
    }
    const Image image = player->read(static_cast<int>(project.passes.size()) - 1);
    int wrong = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) wrong += pixel(image, x, y) != glm::vec4(0, 1, 0, 1);
    EXPECT_EQ(wrong, 0);
  }
};

constexpr const char* painted =
    " gl_FragColor = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }\n";

TEST_P(OtherHosts, GlslSandbox) {
  expect_green("sandbox", std::string(R"(#ifdef GL_ES
precision mediump float;
#endif
#extension GL_OES_standard_derivatives : enable
uniform float time;
uniform vec2 mouse, resolution;
uniform vec2 surfaceSize;
varying vec2 surfacePosition;
float shared_time() { return time * 2.0; }
void main( void ) {
  vec2 middle = (gl_FragCoord.xy - vec2(4.0, 2.0)) / 4.0;
  bool ok = time == 1.5 && shared_time() == 3.0 && resolution == vec2(8.0, 4.0) && mouse == vec2(0.25);
  ok = ok && surfaceSize == vec2(2.0, 1.0) && surfacePosition == middle;
)") + painted);
}

// Of GLSL ES 1.00 browsers take globals that start with uniforms and other globals.
TEST_P(OtherHosts, GlobalsStartWithUniforms) {
  expect_green("globals", R"(precision mediump float;
uniform float time; uniform vec2 mouse, resolution;
struct Camera { float time; } camera;
float t = time * 2.0, u = 1.0, v = u + t,
  w;
vec2 aspect = vec2(resolution.x / resolution.y,
                   1.0);
const float half_ = 0.5;
mat2 turn = mat2(cos(t), sin(t), -sin(t), cos(t));
float f(float t) { return t + v; }
void main() {
  bool ok = t == 3.0 && u == 1.0 && v == 4.0 && w == 0.0 && f(half_) == 4.5 && aspect == vec2(2.0, 1.0);
  ok = ok && turn[0] == vec2(cos(t), sin(t)) && camera.time == 0.0;
  gl_FragData[0] = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

TEST_P(OtherHosts, InvariantVariablesAreVariables) {
  expect_green("invariant", R"(precision mediump float;
invariant varying vec3 normal;
varying vec2 a, b;
invariant a, b;
invariant gl_FragColor;
void main() {
  bool ok = normal == vec3(0.0) && a == b;
  gl_FragColor = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

// GLSL ES 1.00 lets a shader overload every built-in function, and define it again.
TEST_P(OtherHosts, OwnFunctionsBearTheNamesOfBuiltins) {
  expect_green("overloads", R"(precision mediump float;
uniform vec2 resolution;
float equal(float a, float b) { return 1.0 - step(0.01, abs(a - b)); }
float mod(float x) { return x - floor(x); }
mediump float length(float a, const in float b) { return length(vec2(a, b)); }
bvec2 notEqual(vec2 a, vec2 b) { return bvec2(equal(a.x, b.x) == 0.0, true); }
void main() {
  vec2 p = gl_FragCoord.xy / resolution;
  bool ok = equal(1.0, 1.001) == 1.0 && equal(p, p) == bvec2(true) && equal(bvec3(true), bvec3(false)) == bvec3(false);
  ok = ok && abs(length(3.0, 4.0) - 5.0) < 1e-5 && length(vec3(2.0, 0.0, 0.0)) == 2.0 && mod(1.5) == 0.5 && mod(5.0, 3.0) == 2.0;
  ok = ok && notEqual(p, p) == bvec2(false, true) && all(notEqual(vec3(p, 1.0), vec3(p + 1.0, 2.0)));
  gl_FragColor = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

// Shaders of shadertoy.com as they are carried over: own variables or macros for its uniforms, an own main().
TEST_P(OtherHosts, VariablesBearTheNamesOfUniforms) {
  expect_green("carried", std::string(R"(#extension GL_OES_standard_derivatives : enable
uniform float time; uniform vec2 mouse, resolution;
vec3 iResolution;
float iTime = 0.0;
vec4 iMouse = vec4(0.0);
struct Clock { float iTime; };
float tick(float iTime) { Clock clock; clock.iTime = iTime; return clock.iTime; }
void mainImage(out vec4 color, in vec2 at) { color = vec4(iTime, iResolution.xy, tick(7.0)); }
void main() {
  bool ok = time == 1.5 && mouse == vec2(0.25);
  iTime = time; iResolution = vec3(resolution, 1.0);
  vec4 color;
  mainImage(color, gl_FragCoord.xy);
  ok = ok && color == vec4(1.5, 8.0, 4.0, 7.0) && iMouse == vec4(0.0);
)") + painted);
  expect_green("macros", std::string(R"(uniform float time; uniform vec2 resolution;
#define iTime time
#define iResolution resolution
void mainImage(out vec4 color, in vec2 at) { color = vec4(iTime, iResolution, 0.0); }
void main() {
  bool ok = iTime == 1.5;
  mainImage(gl_FragColor, gl_FragCoord.xy);
  ok = ok && gl_FragColor == vec4(1.5, 8.0, 4.0, 0.0);
)") + painted);
}

TEST_P(OtherHosts, InputsThatNoVertexShaderSetsAreZero) {
  expect_green("inputs", R"(#version 300 es
precision highp float;
struct Hit { float t; ivec2 cell; };
in vec2 uv, unused[2];
flat in highp uint count;
flat in ivec3 cells[2];
centroid in mat2 turn;
in vec3[2] pair;
flat in Hit hit;
out vec4 color;
void main() {
  bool ok = uv == vec2(0.0) && unused[int(gl_FragCoord.x) & 1] == vec2(0.0) && count == 0u && cells[1] == ivec3(0);
  ok = ok && turn == mat2(0.0) && pair[1] == vec3(0.0) && hit == Hit(0.0, ivec2(0));
  color = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

TEST_P(OtherHosts, BookOfShadersAndGlslViewer) {
  expect_green("book", std::string(R"(#ifdef GL_ES
precision highp float;
#endif
uniform vec2 u_resolution; uniform vec2 u_mouse;
uniform float u_time; uniform float u_delta;
uniform vec4 u_date; uniform int u_frame;
varying vec2 v_texcoord;
vec2 tile(vec2 u_mouse) { return u_mouse; }
void main() {
  bool ok = u_time == 1.5 && u_delta == 0.25 && u_resolution == vec2(8.0, 4.0) && u_mouse == vec2(2.0, 1.0);
  ok = ok && u_date == vec4(2024.0, 0.0, 31.0, 100.5) && u_frame == 3;
  ok = ok && v_texcoord == gl_FragCoord.xy / vec2(8.0, 4.0) && tile(vec2(7.0)) == vec2(7.0);
)") + painted);
}

TEST_P(OtherHosts, OlderShadertoyPlayersAndOwnTypes) {
  expect_green("older", std::string(R"(uniform highp vec2 iResolution;
uniform float iGlobalTime, iFrame;
uniform vec2
    iMouse;
void main() {
  bool ok = iGlobalTime == 1.5 && iResolution == vec2(8.0, 4.0) && iMouse == vec2(2.0, 1.0) && iFrame == 3.0;
)") + painted);
}

TEST_P(OtherHosts, AnOutputOfOnesOwn) {
  expect_green("own", R"(#version 300 es
precision highp float;
uniform float u_time;
uniform vec3 u_resolution;
out vec4 color;
void main() {
  bool ok = u_time == 1.5 && u_resolution == vec3(8.0, 4.0, 1.0);
  color = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

// The last picture, in bytes from 0 to 1, and nothing before the first.
TEST_P(OtherHosts, BackbufferIsTheLastPictureInBytes) {
  const std::string text = R"(uniform vec2 resolution;
uniform sampler2D backbuffer;
void main() {
  vec4 last = texture2D(backbuffer, gl_FragCoord.xy / resolution);
  gl_FragColor = vec4(last.r + 0.31, last.g + 0.6, 0.0, 1.0);
}
)";
  const Project project = load_project(folder.write("back.frag", text));
  const auto player = play(project);
  for (int i = 0; i < 3; ++i) player->render(frame(i, 8, 4));
  const glm::vec4 third = pixel(player->read(0), 5, 2);
  // 0.31 is 79 of 255, and with 0.31 more 158.
  EXPECT_FLOAT_EQ(third.r, 158.0F / 255.0F + 0.31F);
  EXPECT_FLOAT_EQ(third.g, 1.6F);
}

// As in the extension: these three are set beside mainImage(), too.
TEST_P(OtherHosts, TheExtensionsThreeBesideMainImage) {
  expect_green("three", R"(uniform float time; uniform vec2 resolution; uniform vec2 mouse;
void mainImage(out vec4 color, in vec2 p) {
  bool ok = time == 1.5 && resolution == vec2(8.0, 4.0) && mouse == vec2(0.25);
  color = ok ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}
)");
}

SHADERTWIN_ON_EVERY_PLAYER(OtherHosts);

}  // namespace
}  // namespace shadertwin
