// What --vscode-quirks changes between the passes of a project, on OpenGL and on the twin.
#include <gtest/gtest.h>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

class Quirks : public testing::TestWithParam<std::string> {
 protected:
  Project load(const std::string& shader, bool quirks) const {
    LoadOptions options;
    options.settings.vscode_quirks = quirks;
    return load_project(folder / shader, options);
  }
  static std::unique_ptr<Player> play(const Project& project) {
    if (GetParam() == "cpu") return twin::make_player(project);
    const auto dispatch = GetParam() == "compute" ? gl::Dispatch::compute : gl::Dispatch::fragment;
    return gl::make_player(gl::open_context("llvmpipe"), project, {dispatch});
  }
  static std::vector<float> texels(const Image& image, int count, int channel) {
    std::vector<float> values;
    for (int x = 0; x < count; ++x) values.push_back(image.at(x, 0)[channel]);
    return values;
  }

  ScratchFolder folder;
};

TEST_P(Quirks, AWarmUpAndReadsOfTwoFramesAgo) {
  // Drawn in the order early, plain, late, main. Texel i of early keeps what it read in frame i.
  folder.write(
      "main.glsl",
      "#iChannel0 \"late.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
  folder.write("late.glsl",
               "#iChannel0 \"self\"\n#iChannel1 \"plain.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = vec4(iFrame + 1, iTime, texelFetch(iChannel0, ivec2(0), 0).x, 1);\n}\n");
  folder.write(
      "plain.glsl",
      "#iChannel0 \"early.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(iFrame + 1); }\n");
  folder.write(
      "early.glsl",
      "#iChannel0 \"self\"\n#iChannel1 \"late.glsl\"\n#iChannel2 \"plain.glsl\"\n"
      "void mainImage(out vec4 c, in vec2 p) {\n"
      "  c = texelFetch(iChannel0, ivec2(p), 0);\n  vec4 late = texelFetch(iChannel1, ivec2(0), 0);\n"
      "  if (int(p.x) == iFrame) c = vec4(late.x, late.y, late.z, texelFetch(iChannel2, ivec2(0), 0).x);\n"
      "}\n");
  for (const bool quirks : {false, true}) {
    const Project project = load("main.glsl", quirks);
    ASSERT_EQ(project.passes[0].name, "early");
    const auto player = play(project);
    Schedule schedule;
    schedule.width = 5;
    schedule.height = 2;
    schedule.t0 = 8.0;
    schedule.fps = 1.0;
    FixedClock clock(schedule, host_rules(project));
    for (int i = 0; i < 5; ++i) player->render(clock.next());
    const Image early = player->read(0);
    using Values = std::vector<float>;
    EXPECT_EQ(texels(early, 5, 0), quirks ? Values({1, 0, 1, 2, 3}) : Values({0, 1, 2, 3, 4}));
    EXPECT_EQ(texels(early, 5, 1), quirks ? Values({0, 0, 8, 9, 10}) : Values({0, 8, 9, 10, 11})) << "iTime";
    EXPECT_EQ(texels(early, 5, 2), quirks ? Values({0, 0, 0, 1, 2}) : Values({0, 0, 1, 2, 3}))
        << "late itself reads the frame before, and nothing in the first";
    EXPECT_EQ(texels(early, 5, 3), quirks ? Values({1, 1, 2, 3, 4}) : Values({0, 1, 2, 3, 4}))
        << "a pass with one target";
  }
}

TEST_P(Quirks, BuffersAreReportedAsLargeAsTheyWereAtTheStart) {
  folder.write("main.glsl",
               "#iChannel0 \"buffer.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
               "  c = vec4(iChannelResolution[0].xy, textureSize(iChannel0, 0));\n}\n");
  folder.write("buffer.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  for (const bool quirks : {false, true}) {
    const auto player = play(load("main.glsl", quirks));
    Frame frame;
    const auto reported = [&](int index, int width) {
      frame.index = index;
      frame.width = width;
      frame.height = 4;
      player->render(frame);
      const Image image = player->read(1);
      return std::vector<float>(image.at(0, 0), image.at(0, 0) + 4);
    };
    EXPECT_EQ(reported(0, 8), (std::vector<float>{8, 4, 8, 4}));
    EXPECT_EQ(reported(0, 16), (std::vector<float>{quirks ? 8.0F : 16.0F, 4, 16, 4})) << "a resize";
    EXPECT_EQ(reported(1, 16)[0], quirks ? 8.0F : 16.0F);
    EXPECT_EQ(reported(0, 16)[0], 16.0F) << "started again";
  }
}

INSTANTIATE_TEST_SUITE_P(, Quirks, testing::Values("fragment", "compute", "cpu"),
                         [](const auto& device) { return device.param; });

}  // namespace
}  // namespace shadertwin
