// Uniform values as a shader reads them, frame by frame.
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using UniformsInShaders = OnEveryDevice;

TEST_P(UniformsInShaders, HaveTheValuesOfTheFrame) {
  // One uniform a pixel column, and the alpha as written: the extension's rules.
  const auto shader = folder.write("probe.glsl", R"(
void mainImage(out vec4 color, in vec2 at) {
  int x = int(at.x);
  if (x == 0) color = vec4(iResolution, iTime);
  if (x == 1) color = vec4(iTimeDelta, float(iFrame), iFrameRate, iSampleRate);
  if (x == 2) color = iMouse;
  if (x == 3) color = iDate;
  if (x == 4) color = iMouseButton;
  if (x == 5) color = vec4(iChannelTime[0], iChannelResolution[0]);
  if (x == 6) color = iViewMatrix[1];
}
)");
  Schedule schedule = small(7, 2);
  schedule.fps = 25.0;
  schedule.t0 = 100.0;
  schedule.date = Date::parse("2025-06-30T12:00:00");
  schedule.mouse = {{1, {3.0, 1.0}, true}};
  const auto images = frames(load_project(shader), 3, schedule);
  for (int i = 0; i < 3; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    const double elapsed = i / 25.0;
    EXPECT_EQ(pixel(image, 0), glm::vec4(7, 2, 1, static_cast<float>(100.0 + elapsed)));
    EXPECT_EQ(pixel(image, 1), glm::vec4(i == 0 ? 1.0F / 60.0F : 0.04F, i, 25, 0));
    EXPECT_EQ(pixel(image, 2), i == 0 ? glm::vec4(0) : glm::vec4(3, 1, 3, i == 1 ? 1 : -1));
    EXPECT_EQ(pixel(image, 3), glm::vec4(2025, 5, 30, static_cast<float>(43200.0 + elapsed)));
    EXPECT_EQ(pixel(image, 4), glm::vec4(i == 0 ? 0 : 1, 0, 0, 0));
    EXPECT_EQ(pixel(image, 5), glm::vec4(0));
    EXPECT_EQ(pixel(image, 6), glm::vec4(0, 1, 0, 0));
  }
}

TEST_P(UniformsInShaders, OfTheSiteForceTheImagesAlphaToOne) {
  folder.write("tabs/buffer_a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(.25); }");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) {
  c = vec4(iSampleRate, iChannelResolution[0].xy, texelFetch(iChannel0, ivec2(0), 0).a);
  if (p.x > 1.) c.z = c.a;
}
)");
  const Project project = load_project(folder / "tabs");
  const Image image = frames(project, 1, small())[0];
  EXPECT_EQ(pixel(image, 0), glm::vec4(44100, 4, 3, 1));
  EXPECT_EQ(pixel(image, 1), glm::vec4(44100, 4, 0.25F, 1));
}

TEST_P(UniformsInShaders, FragCoordsArePixelCentres) {
  const auto shader =
      folder.write("centres.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, gl_FragCoord.xy); }");
  const Image image = frames(load_project(shader), 1, small(33, 17))[0];
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      ASSERT_EQ(pixel(image, x, y), glm::vec4(x + 0.5F, y + 0.5F, x + 0.5F, y + 0.5F));
}

TEST_P(UniformsInShaders, UnwrittenColoursAreZeroAndStayUnclamped) {
  const auto shader = folder.write("partly.glsl", R"(
void mainImage(out vec4 c, in vec2 p) {
  if (p.x < 1.) c.x = -3.5;
  else if (p.x < 2.) c.y = 1e30;
}
)");
  const Image image = frames(load_project(shader), 1, small())[0];
  EXPECT_EQ(pixel(image, 0), glm::vec4(-3.5F, 0, 0, 0));
  EXPECT_EQ(pixel(image, 1), glm::vec4(0, 1e30F, 0, 0));
  EXPECT_EQ(pixel(image, 2), glm::vec4(0));
}

TEST_P(UniformsInShaders, CustomUniformsHaveTheirDefaults) {
  const auto shader = folder.write("custom.glsl", R"(
#iUniform float speed = 2.5 in { 0.0, 10.0 }
#iUniform color3 tint = color3(0.25, 0.5, 0.75)
#iUniform int count = 7 in { 0, 10 }
void mainImage(out vec4 c, in vec2 p) { c = p.x < 1. ? vec4(tint, speed) : vec4(float(count)); }
)");
  const Image image = frames(load_project(shader), 1, small())[0];
  EXPECT_EQ(pixel(image, 0), glm::vec4(0.25F, 0.5F, 0.75F, 2.5F));
  EXPECT_EQ(pixel(image, 1), glm::vec4(7));
}

TEST_P(UniformsInShaders, CustomUniformsFollowTheFrame) {
  const auto shader = folder.write("custom.glsl", R"(
#iUniform float speed = 2.5
#iUniform int count = 7
void mainImage(out vec4 c, in vec2 p) { c = vec4(speed, float(count), 0, 1); }
)");
  const Project project = load_project(shader);
  const auto player = play(project);
  Frame frame;
  frame.width = frame.height = 2;
  frame.uniforms = {{-1.5F}, {3.0F}};
  player->render(frame);
  EXPECT_EQ(pixel(player->read(0)), glm::vec4(-1.5F, 3, 0, 1));
  frame.uniforms.clear();
  player->render(frame);
  EXPECT_EQ(pixel(player->read(0)), glm::vec4(2.5F, 7, 0, 1));
}

TEST_P(UniformsInShaders, DefinesOfTheCommandLineReachEveryPass) {
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(KNOB); }");
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "a.glsl"
#ifndef KNOB
#define KNOB 1.0
#endif
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + KNOB; }
)");
  LoadOptions options;
  options.settings.defines = {{"KNOB", "3.0"}};
  EXPECT_EQ(pixel(frames(load_project(shader, options), 1, small())[0]), glm::vec4(6));
}

SHADERTWIN_ON_EVERY_DEVICE(UniformsInShaders);

}  // namespace
}  // namespace shadertwin
