// Files that are saved while the window shows them.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/view/screen.h"

namespace shadertwin {
namespace {

constexpr const char* red = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1, 0, 0, 1); }\n";
constexpr const char* green = "void mainImage(out vec4 c, in vec2 p) { c = vec4(0, 1, 0, 1); }\n";

class Reload : public testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(screen.name().empty()) << "no X server: apt install xvfb"; }

  // Waits for a reload that starts behind `from` in stderr; reports how long the window says that it took.
  static bool reloaded(RunningView& view, std::size_t from) {
    if (!view.says("reloaded in ", from)) return false;
    const std::string text = view.err();
    const std::size_t at = text.find("reloaded in ", from) + 12;
    RecordProperty("milliseconds", text.substr(at, text.find(' ', at) - at));
    return true;
  }

  static glm::vec4 first(const Image& image) {
    return {image.rgba[0], image.rgba[1], image.rgba[2], image.rgba[3]};
  }

  Screen screen;
  ScratchFolder folder;
};

TEST_F(Reload, ASavedShaderAnIncludeAPassAndATextureShow) {
  folder.write("value.glsl", "#define VALUE 1.\n");
  folder.write("buffer.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(2); }\n");
  Image image(2, 2);
  image.rgba.assign(16, 0.25F);
  write_image(image, folder / "picture.exr");
  const std::string text =
      "#include \"value.glsl\"\n#iChannel0 \"buffer.glsl\"\n#iChannel1 \"picture.exr\"\n"
      "void mainImage(out vec4 c, in vec2 p) {\n"
      "  c = vec4(VALUE, texelFetch(iChannel0, ivec2(0), 0).x, texelFetch(iChannel1, ivec2(0), 0).x, MAIN); "
      "}\n";
  folder.write("main.glsl", "#define MAIN 4.\n" + text);
  RunningView view(screen, folder, "main.glsl --size 100x80 --paused");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(first(view.shoot().image), glm::vec4(1, 2, 0.25F, 4));
  std::size_t before = view.err().size();
  const auto expect = [&](const glm::vec4& value) {
    ASSERT_TRUE(reloaded(view, before)) << view.err();
    EXPECT_EQ(first(view.shoot().image), value);
    before = view.err().size();
  };
  folder.write("main.glsl", "#define MAIN 5.\n" + text);
  expect({1, 2, 0.25F, 5});
  folder.write("value.glsl", "#define VALUE 6.\n");
  expect({6, 2, 0.25F, 5});
  folder.write("buffer.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(7); }\n");
  expect({6, 7, 0.25F, 5});
  image.rgba.assign(16, 0.75F);
  write_image(image, folder / "picture.exr");  // which renames a finished file, as editors do
  expect({6, 7, 0.75F, 5});
}

TEST_F(Reload, ABrokenSaveShowsItsErrorOverTheLastPictureAndRecovers) {
  folder.write("a.glsl", green);
  RunningView view(screen, folder, "a.glsl --size 300x200");
  ASSERT_TRUE(view.running()) << view.err();
  EXPECT_EQ(first(view.shoot().image), glm::vec4(0, 1, 0, 1));
  view.key("F2");
  ASSERT_TRUE(eventually([&] { return screen.pixel(250, 20) == glm::ivec3(0, 255, 0); }));
  std::size_t before = view.err().size();
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n  c = unknown;\n}\n");
  ASSERT_TRUE(view.says("a.glsl:2: error:", before)) << view.err();
  EXPECT_NE(view.err().find("unknown", before), std::string::npos);
  // A dark red box at the bottom; the picture above it stays.
  EXPECT_TRUE(eventually([&] {
    const glm::ivec3 box = screen.pixel(280, 185);
    return box.x > box.y && box.x > 30 && box.y < 60;
  }));
  EXPECT_EQ(first(view.shoot().image), glm::vec4(0, 1, 0, 1));
  before = view.err().size();
  folder.write("a.glsl", red);
  ASSERT_TRUE(reloaded(view, before)) << view.err();
  EXPECT_EQ(first(view.shoot().image), glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(eventually([&] { return screen.pixel(280, 185) == glm::ivec3(255, 0, 0); }))
      << "the box is gone";
  // An include that is not there yet mends it when it comes.
  before = view.err().size();
  folder.write("a.glsl", std::string("#include \"late.glsl\"\n") + green);
  ASSERT_TRUE(view.says("late.glsl", before)) << view.err();
  before = view.err().size();
  folder.write("late.glsl", "\n");
  ASSERT_TRUE(reloaded(view, before)) << view.err();
  EXPECT_EQ(first(view.shoot().image), glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(view.quit(), 0);
}

// shadertoy.com goes on where it was; the extension counts its frames anew.
TEST_F(Reload, BuffersAreKeptOnTheSiteAndStartOverInTheExtension) {
  const std::string count =
      "void mainImage(out vec4 c, in vec2 p) {\n"
      "  c = texelFetch(iChannel0, ivec2(p), 0) + vec4(1, iFrame == 0 ? 1 : 0, 0, 1); }\n";
  const std::string show =
      "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }\n";
  folder.write("tabs/buffer_a.glsl", "#iChannel0 \"buffer_a.glsl\"\n" + count);
  folder.write("tabs/image.glsl", "#iChannel0 \"buffer_a.glsl\"\n" + show);
  folder.write("file/main.glsl", "#iChannel0 \"self\"\n" + count);
  for (const bool site : {true, false}) {
    RunningView view(screen, folder,
                     site ? "tabs --size 100x80 --paused" : "file/main.glsl --size 100x80 --paused");
    ASSERT_TRUE(view.running()) << view.err();
    view.step(4);
    EXPECT_EQ(view.shoot().image.rgba[0], 5.0F);
    const std::size_t before = view.err().size();
    if (site)
      folder.write("tabs/image.glsl", "#iChannel0 \"buffer_a.glsl\"\n\n" + show);
    else
      folder.write("file/main.glsl", "#iChannel0 \"self\"\n\n" + count);
    ASSERT_TRUE(reloaded(view, before)) << view.err();
    const auto shot = view.shoot();
    EXPECT_EQ(shot.image.rgba[0], site ? 6.0F : 1.0F);
    EXPECT_EQ(shot.image.rgba[1], 1.0F);
    EXPECT_EQ(shot.frame, site ? 5 : 0);
    if (!site) continue;
    // A larger window keeps the old pixels in its lower left corner, and counts on.
    screen.hand("windowsize --sync " + view.window() + " 140 90");
    ASSERT_TRUE(eventually([&] { return view.shoot().image.width == 140; }));
    const auto larger = view.shoot();
    EXPECT_GE(larger.image.at(99, 79)[0], 7.0F);
    EXPECT_EQ(larger.image.at(99, 79)[1], 1.0F) << "frame 0 was not drawn again";
    EXPECT_EQ(larger.image.at(120, 85)[1], 0.0F);
  }
}

std::size_t resident_kilobytes(pid_t pid) {
  std::ifstream stream("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("VmRSS:")) return static_cast<std::size_t>(std::atol(line.c_str() + 6));
  return 0;
}

std::size_t open_files(pid_t pid) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/fd"))
    ++count;
  return count;
}

TEST_F(Reload, AScreenshotBeforeTheFirstFrameOfANewShaderWaitsForIt) {
  folder.write("a.glsl", green);
  RunningView view(screen, folder, "a.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  std::string often = "--delay 1";
  for (int i = 0; i < 30; ++i) often += " F12";
  for (int i = 0; i < 8; ++i) {
    const std::size_t before = view.err().size();
    folder.write("a.glsl", (i % 2 == 0 ? red : green) + ("// " + std::to_string(i) + "\n"));
    view.key(often);
    ASSERT_TRUE(view.says("reloaded in ", before)) << view.err();
  }
  EXPECT_EQ(view.err().find("read back"), std::string::npos) << view.err();
  EXPECT_EQ(first(view.shoot().image), glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(view.quit(), 0);
}

TEST_F(Reload, LeaksNothing) {
  folder.write("a.glsl", green);
  RunningView view(screen, folder, "a.glsl --size 100x80");
  ASSERT_TRUE(view.running()) << view.err();
  const auto reload = [&](int i) {
    const std::size_t before = view.err().size();
    folder.write("a.glsl", (i % 2 == 0 ? red : green) + ("// " + std::to_string(i) + "\n"));
    return view.says("reloaded in ", before);
  };
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(reload(i)) << view.err();
  const std::size_t memory = resident_kilobytes(view.pid());
  const std::size_t files = open_files(view.pid());
  for (int i = 20; i < 60; ++i) ASSERT_TRUE(reload(i)) << view.err();
  EXPECT_LT(resident_kilobytes(view.pid()), memory + 8 * 1024)
      << "kilobytes after 40 reloads, from " << memory;
  EXPECT_EQ(open_files(view.pid()), files);
  EXPECT_EQ(view.quit(), 0);
}

}  // namespace
}  // namespace shadertwin
