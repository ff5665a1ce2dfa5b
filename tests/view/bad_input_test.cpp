// What goes wrong before there is a window ends with one line; what goes wrong later shows over the picture.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/view/screen.h"

namespace shadertwin {
namespace {

constexpr const char* plain =
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, 0, 1); }\n";

class BadInputToView : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_FALSE(screen.name().empty()) << "no X server: apt install xvfb";
    folder.write("a.glsl", plain);
  }

  void expect_end(int status, const std::string& arguments, const std::vector<std::string>& environment,
                  const std::vector<std::string>& words) {
    RunningView view(screen, folder, arguments, environment);
    EXPECT_EQ(view.wait_for_end(), status) << view.err();
    const std::string err = view.err();
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
    for (const std::string& word : words) EXPECT_NE(err.find(word), std::string::npos) << err;
  }

  Screen screen;
  ScratchFolder folder;
};

TEST_F(BadInputToView, NoDisplay) {
  expect_end(5, "a.glsl", {"DISPLAY="}, {"shadertwin render"});
  expect_end(5, "a.glsl", {"DISPLAY=:987"}, {"shadertwin render"});
}

TEST_F(BadInputToView, OpenGlTooOld) {
  expect_end(5, "a.glsl", {"MESA_GLES_VERSION_OVERRIDE=2.0"}, {"OpenGL ES 3", "shadertwin render"});
}

TEST_F(BadInputToView, ShadersThatNeverWorked) {
  folder.write("syntax.glsl", "void mainImage(out vec4 c, in vec2 p) {\n c = unknown;\n}\n");
  expect_end(3, "syntax.glsl", {}, {"syntax.glsl:2: error:"});
  expect_end(4, "none.glsl", {}, {"none.glsl"});
  expect_end(2, "a.glsl --pass nonsense", {}, {"--pass nonsense"});
  expect_end(2, "a.glsl --size 0x0", {}, {"--size 0x0"});
  expect_end(2, "a.glsl --on vulkan", {}, {"vulkan"});
  expect_end(2, "a.glsl --media .", {}, {"--media is for a Shadertoy JSON, not for a.glsl"});
  expect_end(2, "a.glsl --dialect shadertoy --vscode-quirks", {},
             {"--vscode-quirks is for the rules of vscode"});
}

TEST_F(BadInputToView, AShaderThatIsRemovedAndATextureThatTurnsToGarbage) {
  Image image(2, 2);
  image.rgba.assign(16, 0.5F);
  write_image(image, folder / "t.exr");
  const std::string text =
      "#iChannel0 \"t.exr\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(0), 0); "
      "}\n";
  folder.write("b.glsl", text);
  RunningView view(screen, folder, "b.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], 0.5F);
  std::size_t before = view.err().size();
  std::filesystem::remove(folder / "b.glsl");
  ASSERT_TRUE(view.says("b.glsl", before)) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], 0.5F) << "the last picture stays";
  before = view.err().size();
  folder.write("b.glsl", text);
  ASSERT_TRUE(view.says("reloaded", before)) << view.err();
  before = view.err().size();
  folder.write("t.exr", "this is not a picture");
  ASSERT_TRUE(view.says("t.exr", before)) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], 0.5F);
  image.rgba.assign(16, 0.25F);
  before = view.err().size();
  write_image(image, folder / "t.exr");
  ASSERT_TRUE(view.says("reloaded", before)) << view.err();
  EXPECT_EQ(view.shoot().image.rgba[0], 0.25F);
  EXPECT_EQ(view.quit(), 0);
}

TEST_F(BadInputToView, OnePixelAndEightThousand) {
  RunningView view(screen, folder, "a.glsl --size 100x80 --paused");
  ASSERT_TRUE(view.running()) << view.err();
  // Judged on the screen, as a screenshot of 8K takes minutes on a busy machine; in the first row, which the
  // line of frames and seconds leaves alone.
  const auto shows = [&](glm::ivec2 size) {
    const int x = std::min(size.x, 100) - 1;
    const glm::ivec3 seen = screen.pixel(x, 0);
    return std::abs(seen.r - 255 * (x + 0.5) / size.x) <= 1 &&
           std::abs(seen.g - 255 * (size.y - 0.5) / size.y) <= 1 && seen.b == 0;
  };
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {7680, 4320}, {3, 500}, {100, 80}}) {
    screen.hand("windowsize --sync " + view.window() + ' ' + std::to_string(size.x) + ' ' +
                std::to_string(size.y));
    EXPECT_TRUE(eventually([&] { return shows(size); })) << size.x << 'x' << size.y << ' ' << view.err();
  }
  EXPECT_EQ(view.shoot().image.width, 100);
  EXPECT_EQ(view.quit(), 0) << view.err();
}

TEST_F(BadInputToView, AThousandKeyEvents) {
  folder.write("k.glsl",
               "#iKeyboard\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(isKeyDown(Key_A), "
               "isKeyToggled(Key_A), 0, 1); }\n");
  RunningView view(screen, folder, "k.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  view.shoot();
  // 501 presses and as many releases, as fast as the server takes them.
  std::string keys;
  for (int i = 0; i < 501; ++i) keys += " a";
  screen.hand("key --delay 1" + keys);
  EXPECT_TRUE(eventually([&] {
    const auto shot = view.shoot();
    return shot.image.rgba[0] == 0.0F && shot.image.rgba[1] == 1.0F;
  })) << "an odd number of presses leaves the key toggled";
  EXPECT_EQ(view.quit(), 0);
}

}  // namespace
}  // namespace shadertwin
