// What a hand does in the window reaches the shader as it would on shadertoy.com.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/view/screen.h"

namespace shadertwin {
namespace {

// Texel number iFrame of a picture keeps VALUE of that frame.
std::string history_of(const std::string& value) {
  return "#iKeyboard\n#iChannel0 \"self\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
         "  c = texelFetch(iChannel0, ivec2(p), 0);\n"
         "  if (int(p.y) * int(iResolution.x) + int(p.x) == iFrame) c = " +
         value + ";\n}\n";
}

class Hand : public testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(screen.name().empty()) << "no X server: apt install xvfb"; }

  // The values that texels 0 to `frame` hold, each once as long as it stays the same.
  static std::vector<glm::vec4> distinct(const RunningView::Shot& shot) {
    std::vector<glm::vec4> values;
    for (int i = 0; i <= shot.frame; ++i) {
      const float* p = shot.image.at(i % shot.image.width, i / shot.image.width);
      const glm::vec4 value(p[0], p[1], p[2], p[3]);
      if (values.empty() || values.back() != value) values.push_back(value);
    }
    return values;
  }

  std::string render(const std::string& arguments, const std::string& output) const {
    const std::string command = "cd '" + folder.path().string() + "' && '" SHADERTWIN_BINARY "' render " +
                                arguments + " --quiet -o " + output + " 2>&1";
    return std::system(command.c_str()) == 0 ? "" : "failed: " + command;
  }

  std::string bytes(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  Screen screen;
  ScratchFolder folder;
};

using Values = std::vector<glm::vec4>;

TEST_F(Hand, MouseIsShadertoysFromPressToDragToRelease) {
  folder.write("mouse.glsl", history_of("iMouse"));
  RunningView view(screen, folder, "mouse.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  screen.hand("mousemove 10 20");
  view.let_frames_pass();
  screen.hand("mousedown 1");
  view.let_frames_pass();
  screen.hand("mousemove 30 5");
  view.let_frames_pass();
  screen.hand("mouseup 1");
  view.let_frames_pass();
  screen.hand("mousemove 50 50");
  view.let_frames_pass();
  // A click that is over before the next frame, by the right button, in the top left corner.
  screen.hand("mousemove 0 0 click 3");
  view.let_frames_pass();
  const auto shot = view.shoot();
  // The pixel under the pointer is centred on (x + 0.5, y - 0.5).
  const Values expected = {{0, 0, 0, 0},        // never clicked
                           {10, 60, 10, 60},    // the frame after the press
                           {10, 60, 10, -60},   // held
                           {30, 75, 10, -60},   // dragged
                           {30, 75, -10, -60},  // released; moving on changes nothing
                           {0, 80, -0.0F, 80},  // pressed and released between two frames
                           {0, 80, -0.0F, -80}};
  auto seen = distinct(shot);
  // Where a slow machine drew a frame between the press and the release, the click was an ordinary one.
  std::erase(seen, glm::vec4(0, 80, 0, 80));
  auto wanted = expected;
  std::erase(wanted, glm::vec4(0, 80, 0, 80));
  EXPECT_EQ(seen, wanted);
  EXPECT_EQ(view.quit(), 0) << view.err();
}

TEST_F(Hand, MouseIsInPixelsOfAScaledPicture) {
  folder.write("mouse.glsl", history_of("iMouse"));
  RunningView view(screen, folder, "mouse.glsl --size 120x80");
  ASSERT_TRUE(view.running()) << view.err();
  view.key("F10");
  ASSERT_TRUE(eventually([&] { return view.shoot().image.width == 60; }));
  screen.hand("mousemove 100 20 mousedown 1");
  view.let_frames_pass();
  screen.hand("mousemove 40 60");
  view.let_frames_pass();
  const auto seen = distinct(view.shoot());
  const Values expected = {{0, 0, 0, 0}, {50, 30, 50, 30}, {50, 30, 50, -30}, {20, 10, 50, -30}};
  EXPECT_EQ(seen, expected);
  view.key("F10 F10");
  EXPECT_TRUE(eventually([&] { return view.shoot().image.width == 240; }));
}

TEST_F(Hand, KeysAreHeldPressedAndToggled) {
  folder.write(
      "keys.glsl",
      history_of("vec4(isKeyDown(Key_A), isKeyPressed(Key_A), isKeyToggled(Key_A), isKeyDown(Key_F12))"));
  RunningView view(screen, folder, "keys.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  view.let_frames_pass();
  for (int press = 0; press < 2; ++press) {
    screen.hand("keydown a");
    view.let_frames_pass();
    screen.hand("keyup a");
    view.let_frames_pass();
  }
  const Values expected = {{0, 0, 0, 0}, {1, 1, 1, 0}, {1, 0, 1, 0}, {0, 0, 1, 0},
                           {1, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}};
  EXPECT_EQ(distinct(view.shoot()), expected) << "F12, which is the window's, must not show";
}

TEST_F(Hand, ScreenshotIsTheFrameThatRenderDrawsBitForBit) {
  folder.write("wave.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) {
  vec4 old = texelFetch(iChannel0, ivec2(p), 0);
  c = iFrame == 0 ? vec4(p / iResolution.xy, 0, 1)
                  : old * .9 + vec4(fract(iTime * 1.7), iDate.w * .01, float(iFrame) * .1, sin(iTimeDelta));
}
)");
  RunningView view(screen, folder, "wave.glsl --size 96x54 --fixed --fps 24 --time 2 --paused");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(view.shoot().frame, 0);
  view.step(6);
  const auto shot = view.shoot();
  EXPECT_EQ(shot.frame, 6) << "stepping draws one frame a press";
  ASSERT_EQ(render("wave.glsl --size 96x54 --fps 24 --time 2 --frames 7", "render.exr"), "");
  ASSERT_EQ(render("wave.glsl --size 96x54 --fps 24 --time 2 --frames 7", "render.png"), "");
  EXPECT_EQ(shot.image.rgba, read_image(folder / "render.exr").rgba);
  EXPECT_EQ(bytes(shot.name + ".png"), bytes("render.png")) << "no HUD in it";
  // What the window itself shows, once the HUD is off.
  view.key("F2");
  const float* p = shot.image.at(10, 53 - 20);
  const auto shown = [](float value) {
    return static_cast<int>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
  };
  const glm::ivec3 expected(shown(p[0]), shown(p[1]), shown(p[2]));
  EXPECT_TRUE(eventually([&] { return screen.pixel(10, 20) == expected; }))
      << screen.pixel(10, 20).x << ' ' << screen.pixel(10, 20).y << ' ' << screen.pixel(10, 20).z;
  view.key("F5");
  EXPECT_TRUE(eventually([&] { return view.shoot().frame == 0; })) << "back to zero";
  EXPECT_EQ(view.quit(), 0);
}

TEST_F(Hand, RecordingIsWhatRenderDraws) {
  folder.write("time.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime * 1.7), p / 99., 1); }\n");
  RunningView view(screen, folder, "time.glsl --size 64x36 --fps 30 --fixed --paused -o clip");
  ASSERT_TRUE(view.running()) << view.err();
  view.shoot();
  view.key("shift+F12");
  view.step(3);
  view.key("shift+F12");
  ASSERT_TRUE(view.says("clip_recording_0001: 3 frames")) << view.err();
  ASSERT_EQ(render("time.glsl --size 64x36 --fps 30 --frames 4", "frame_%04d.png"), "");
  for (int i = 0; i < 3; ++i) {
    const std::string recorded = "clip_recording_0001/frame_000" + std::to_string(i) + ".png";
    EXPECT_EQ(bytes(recorded), bytes("frame_000" + std::to_string(i + 1) + ".png")) << recorded;
  }
}

TEST_F(Hand, OtherPassesCanBeShownAndInspected) {
  folder.write("buffer.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(-7.5, p, 1e30); }\n");
  folder.write("main.glsl",
               "#iChannel0 \"buffer.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) * .5; }\n");
  RunningView view(screen, folder, "main.glsl --size 640x360 --fixed --paused -D K=2");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], -3.75F);
  view.key("F8");
  EXPECT_TRUE(eventually([&] { return view.shoot().image.rgba[0] == -7.5F; }));
  view.key("F3");
  view.step(1);
  screen.hand("mousemove 60 200 sleep 0.3 click 1");
  EXPECT_TRUE(eventually([&] { return view.out().ends_with("--on cpu\n"); })) << view.out();
  EXPECT_TRUE(view.out().starts_with(
      "shadertwin debug main.glsl --size 640x360 --fps 60 --frames 2 --pass buffer -D K=2 --pixel 60,159\n"))
      << view.out();
}

TEST_F(Hand, InspectedFramesAreDrawnAgainWithTheOptionsThatWereGiven) {
  folder.write("media/unused.txt", "");
  folder.write("toy.json",
               R"({"renderpass":[{"inputs":[],"outputs":[],"type":"image","code":)"
               R"("void mainImage(out vec4 c, in vec2 p) { c = vec4(K, iDate.x, SEED, 1); }"}]})");
  RunningView view(
      screen, folder,
      "toy.json --size 640x360 --fixed --paused --date 2025-06-30 -D K=1 -D T=vec2(1,2) --seed 3 "
      "--media media --dialect vscode --mute --vscode-quirks --precise --init raw --init zero");
  ASSERT_TRUE(view.running()) << view.err();
  view.shoot();
  view.key("F3");
  screen.hand("mousemove 60 200 sleep 0.3 click 1");
  EXPECT_TRUE(eventually([&] { return view.out().ends_with("--on cpu\n"); })) << view.out();
  const std::string options =
      " --date 2025-06-30T00:00:00 --mouse -1,-1 -D K=1 -D 'T=vec2(1,2)' --seed 3 --media media --dialect "
      "vscode "
      "--mute --vscode-quirks --init zero --precise ";
  EXPECT_NE(view.out().find("shadertwin debug toy.json --size 640x360 --fps 60 --frames"), std::string::npos)
      << view.out();
  EXPECT_NE(view.out().find(options + "--pixel"), std::string::npos) << view.out();
  EXPECT_NE(view.out().find(options + "--on auto --on cpu"), std::string::npos) << view.out();
}

TEST_F(Hand, NotANumberIsPainted) {
  folder.write(
      "nan.glsl",
      "void mainImage(out vec4 c, in vec2 p) {\n"
      "  uint bits = p.x < 50. ? 0x7fc00000u : p.x < 100. ? 0x7f800000u : p.x < 150. ? 0xff800000u : 0u;\n"
      "  c = vec4(0, 0, 0, uintBitsToFloat(bits));\n}\n");
  RunningView view(screen, folder, "nan.glsl --size 200x100 --paused");
  ASSERT_TRUE(view.running()) << view.err();
  view.shoot();
  view.key("F2");
  EXPECT_TRUE(eventually([&] { return screen.pixel(25, 90) == glm::ivec3(0); }));
  view.key("shift+F3");
  EXPECT_TRUE(eventually([&] { return screen.pixel(25, 90) == glm::ivec3(255, 0, 255); }));
  EXPECT_EQ(screen.pixel(75, 90), glm::ivec3(255, 255, 0));
  EXPECT_EQ(screen.pixel(125, 90), glm::ivec3(0, 255, 255));
  EXPECT_EQ(screen.pixel(175, 90), glm::ivec3(0, 0, 0));
}

TEST_F(Hand, SlidersChangeTheShaderOutliveAReloadAndCanBeCopied) {
  const std::string text = R"(
#iUniform float speed = 2.5 in { 0.0, 10.0 }
#iUniform color3 tint = color3(0.25, 0.5, 0.75)
void mainImage(out vec4 c, in vec2 p) { c = vec4(speed, tint); }
)";
  folder.write("custom.glsl", text);
  RunningView view(screen, folder, "custom.glsl --size 640x360 --paused");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], 2.5F);
  screen.hand("mousemove 540 45 sleep 0.3 mousedown 1 sleep 0.3 mouseup 1");
  float set = 2.5F;
  EXPECT_TRUE(eventually([&] { return (set = view.shoot().image.rgba[0]) != 2.5F; })) << "the slider moves";
  EXPECT_GT(set, 5.0F);
  EXPECT_LT(set, 10.0F);
  const std::size_t before = view.err().size();
  folder.write("custom.glsl", text + "// saved\n");
  ASSERT_TRUE(view.says("reloaded", before)) << view.err();
  const auto shot = view.shoot();
  EXPECT_EQ(shot.image.rgba[0], set);
  EXPECT_EQ(shot.image.rgba[3], 0.75F);
  // The button below the two fields. What it copies makes `render` draw the same.
  screen.hand("mousemove 450 90 sleep 0.3 mousedown 1 sleep 0.3 mouseup 1");
  ASSERT_TRUE(view.says("copied: ")) << view.err();
  std::string options = view.err().substr(view.err().rfind("copied: ") + 8);
  options = options.substr(0, options.find('\n'));
  ASSERT_EQ(render("custom.glsl --size 640x360 " + options, "a.exr"), "");
  EXPECT_EQ(read_image(folder / "a.exr").rgba, shot.image.rgba);
}

TEST_F(Hand, OtherPlayersShowInTheWindow) {
  folder.write("time.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / 99., fract(iTime * 1.7), 1); }\n");
  RunningView view(screen, folder, "time.glsl --size 64x36 --fixed --paused --on cpu");
  ASSERT_TRUE(view.running()) << view.err();
  view.step(2);
  const auto shot = view.shoot();
  EXPECT_EQ(shot.frame, 2);
  ASSERT_EQ(render("time.glsl --size 64x36 --frames 3 --on cpu", "a.exr"), "");
  EXPECT_EQ(shot.image.rgba, read_image(folder / "a.exr").rgba);
  EXPECT_EQ(view.quit(), 0);
}

}  // namespace
}  // namespace shadertwin
