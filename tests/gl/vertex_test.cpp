// #iVertex: passes that place their own two triangles.
#include "host/base/error.h"
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using Vertex = OnEveryDevice;

constexpr const char* covers = R"(
varying vec2 across;
const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
void main() {
  across = 0.5 + 0.5 * corners[gl_VertexID];
  gl_Position = vec4(corners[gl_VertexID] * vec2(SCALE, 1), 0, 1);
}
)";
constexpr const char* shows = R"(
#iVertex "v.glsl"
in vec2 across;
void mainImage(out vec4 c, in vec2 p) { c = vec4(across, p.x, 1); }
)";

TEST_P(Vertex, TwoTrianglesFromSixVerticesCarryTheirOutputs) {
  folder.write("v.glsl", covers);
  const Project project =
      load_project(folder.write("x.glsl", shows), {.settings = {.defines = {{"SCALE", "1.0"}}}});
  const Image image = frames(project, 1, small(4, 2)).back();
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) {
      EXPECT_NEAR(pixel(image, x, y).x, (static_cast<float>(x) + 0.5F) / 4.0F, 1e-6F);
      EXPECT_NEAR(pixel(image, x, y).y, (static_cast<float>(y) + 0.5F) / 2.0F, 1e-6F);
      EXPECT_EQ(pixel(image, x, y).z, static_cast<float>(x) + 0.5F);
    }
}

TEST_P(Vertex, WhatNoTriangleCoversIsZeroAndBacksAreNotDrawn) {
  folder.write("v.glsl", covers);
  const auto shader = folder.write("x.glsl", shows);
  const Image half =
      frames(load_project(shader, {.settings = {.defines = {{"SCALE", "0.5"}}}}), 2, small(4, 2)).back();
  EXPECT_EQ(pixel(half, 0, 0), glm::vec4(0));
  EXPECT_EQ(pixel(half, 3, 1), glm::vec4(0));
  EXPECT_EQ(pixel(half, 1, 0).a, 1.0F);
  const Image back =
      frames(load_project(shader, {.settings = {.defines = {{"SCALE", "(-1.0)"}}}}), 1, small(4, 2)).back();
  EXPECT_EQ(pixel(back, 1, 0), glm::vec4(0)) << "mirrored, the triangles turn their backs";
}

TEST_P(Vertex, ReadsTheUniformsAndChannelsOfItsPass) {
  folder.write("b.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame), 0, 0, 1); }");
  folder.write("v.glsl", R"(
flat out vec4 seen;
void main() {
  seen = vec4(texelFetch(iChannel2, ivec2(0), 0).r, strength, iResolution.xy);
  gl_Position = vec4(vec2(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1), 0, gl_VertexID < 3 ? 1 : -1);
}
)");
  const Project project = load_project(folder.write("x.glsl", R"(
#iChannel2 "b.glsl"
#iUniform float strength = 0.25 in { 0, 1 }
#iVertex "v.glsl"
flat in vec4 seen;
void main() { gl_FragColor = seen; }
)"));
  EXPECT_EQ(pixel(frames(project, 3, small(4, 2)).back()), glm::vec4(2, 0.25F, 4, 2));
}

// WebGL2 refuses to draw with a block that has no buffer, whichever text has it.
TEST_P(Vertex, AUniformBlockDrawsNothing) {
  folder.write("v.glsl", R"(
layout(std140) uniform Place { mat4 matrix; vec2 shift; } place[2];
void main() {
  vec2 corner = vec2(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1);
  gl_Position = vec4(corner + place[1].shift + place[0].matrix[0].xy, 0, gl_VertexID < 3 ? 1 : -1);
}
)");
  const Project project = load_project(folder.write(
      "x.glsl", "#iVertex \"v.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n"));
  EXPECT_EQ(pixel(frames(project, 1, small(4, 2)).back()), glm::vec4(0));
  ASSERT_EQ(project.passes.back().other_uniforms.size(), 1U);
  EXPECT_EQ(project.passes.back().other_uniforms[0].name, "Place");
}

TEST_P(Vertex, RunsAsFragmentsAndSaysSo) {
  folder.write("v.glsl", covers);
  const Project project =
      load_project(folder.write("x.glsl", shows), {.settings = {.defines = {{"SCALE", "1.0"}}}});
  const auto player = play(project);
  EXPECT_NE(player->description().find("/fragment"), std::string::npos);
  if (GetParam().dispatch == gl::Dispatch::compute)
    EXPECT_EQ(player->warnings(),
              std::vector<std::string>{"x: warning: runs as fragments: it has its own vertex shader"});
  else
    EXPECT_TRUE(player->warnings().empty());
}

TEST_P(Vertex, ErrorsNameItsOwnFileAndLine) {
  folder.write("v.glsl", "void main() {\n  gl_Position = vec4(nothing);\n}\n");
  const Project project =
      load_project(folder.write("x.glsl", shows), {.settings = {.defines = {{"SCALE", "1.0"}}}});
  try {
    play(project);
    FAIL() << "it compiles";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::shader);
    EXPECT_NE(std::string(error.what()).find("v.glsl:2: error: "), std::string::npos) << error.what();
  }
}

SHADERTWIN_ON_EVERY_DEVICE(Vertex);

}  // namespace
}  // namespace shadertwin
