// What stands on the screen, and what a resize does to it in each dialect.
#include <gtest/gtest.h>

#include "tests/view/screen.h"

namespace shadertwin {
namespace {

class Shown : public testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(screen.name().empty()) << "no X server: apt install xvfb"; }

  static glm::vec4 pixel(const RunningView::Shot& shot, int x, int y) {
    const float* p = shot.image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
  }

  Screen screen;
  ScratchFolder folder;
};

TEST_F(Shown, EightBitValuesAreThoseValuesOnTheScreen) {
  Image grey(256, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 256; ++x)
      for (int i = 0; i < 4; ++i) grey.at(x, y)[i] = i == 3 ? 1.0F : static_cast<float>(x) / 255.0F;
  write_image(grey, folder / "grey.png");
  folder.write(
      "grey.glsl",
      "#iChannel0 \"grey.png\"\n#iChannel0::MinFilter \"Nearest\"\n#iChannel0::MagFilter \"Nearest\"\n"
      "void mainImage(out vec4 c, in vec2 p) {\n"
      "  c = p.y < 40. ? texelFetch(iChannel0, ivec2(p.x, 0), 0) : vec4(floor(p.x) / 255.);\n}\n");
  for (const std::string on : {"", " --on cpu"}) {
    RunningView view(screen, folder, "grey.glsl --size 256x80 --paused" + on);
    ASSERT_TRUE(view.running()) << view.err();
    view.shoot();
    view.key("F2");
    for (const int y : {20, 60}) {
      ASSERT_TRUE(eventually([&] { return screen.pixel(128, y) == glm::ivec3(128) || !view.running(); }))
          << screen.pixel(128, y).x << " instead of 128" << on;
      for (int x = 0; x < 256; x += 17) EXPECT_EQ(screen.pixel(x, y), glm::ivec3(x)) << x << ", " << y << on;
    }
    EXPECT_EQ(view.quit(), 0);
  }
}

constexpr const char* counting =
    "void mainImage(out vec4 c, in vec2 p) {\n"
    "  c = texelFetch(iChannel0, ivec2(p), 0) + (iFrame == 0 ? vec4(1, 0, 0, 0) : vec4(0, 1, 0, 0));\n"
    "  c.zw = vec2(iTime, iResolution.x);\n}\n";

TEST_F(Shown, AResizeStartsTheExtensionAnewButForItsTime) {
  folder.write("count.glsl", std::string("#iChannel0 \"self\"\n") + counting);
  RunningView view(screen, folder, "count.glsl --size 100x80 --paused --fixed --fps 4");
  ASSERT_TRUE(view.running()) << view.err();
  view.step(6);
  auto shot = view.shoot();
  EXPECT_EQ(shot.frame, 6);
  EXPECT_EQ(pixel(shot, 0, 0), glm::vec4(1, 6, 1.5F, 100)) << "frame 0 is drawn once";
  screen.hand("windowsize " + view.window() + " 150 90");
  ASSERT_TRUE(eventually([&] { return (shot = view.shoot()).image.width == 150; }));
  EXPECT_EQ(shot.frame, 0);
  EXPECT_EQ(pixel(shot, 0, 0), glm::vec4(1, 0, 1.5F, 150)) << "buffers are lost, time goes on";
  EXPECT_EQ(pixel(shot, 149, 89), glm::vec4(1, 0, 1.5F, 150));
  view.step(2);
  shot = view.shoot();
  EXPECT_EQ(shot.frame, 2);
  EXPECT_EQ(pixel(shot, 0, 0), glm::vec4(1, 2, 2.0F, 150));
  EXPECT_EQ(view.quit(), 0);
}

TEST_F(Shown, AResizeOnTheSiteCountsOnAndKeepsTheBuffersFromTheLowerLeft) {
  folder.write("tabs/image.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }\n");
  folder.write("tabs/buffer_a.glsl", counting);
  folder.write(
      "tabs/shadertoy.json",
      R"({"Image": {"iChannel0": {"buffer": "Buffer A"}}, "Buffer A": {"iChannel0": {"buffer": "Buffer A"}}})");
  RunningView view(screen, folder, "tabs --size 100x80 --paused --fixed --fps 4 --pass buffera");
  ASSERT_TRUE(view.running()) << view.err();
  view.step(
      5);  // so that the first of the buffer's two pictures, which counts from then on, is the newer one
  screen.hand("windowsize " + view.window() + " 150 90");
  auto shot = view.shoot();
  ASSERT_TRUE(eventually([&] { return (shot = view.shoot()).image.width == 150; }));
  EXPECT_EQ(shot.frame, 6) << "one frame more, of the new size";
  EXPECT_EQ(pixel(shot, 0, 0), glm::vec4(1, 6, 1.25F, 150));
  EXPECT_EQ(pixel(shot, 99, 79), glm::vec4(1, 6, 1.25F, 150));
  EXPECT_EQ(pixel(shot, 100, 80), glm::vec4(0, 1, 1.25F, 150));
  EXPECT_EQ(view.quit(), 0);
}

}  // namespace
}  // namespace shadertwin
