// An option that would change nothing of what was asked is refused, not ignored.
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

constexpr const char* plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.xyxy); }\n";

class RefusedOptions : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("a.glsl", plain);
    folder.write("toy/image.glsl", plain);
    folder.write("toy/sound.glsl", "vec2 mainSound(int s, float t) { return vec2(0.0); }\n");
  }

  // Expects status 2, one line that names the option, and no output.
  void refuses(const std::string& option, const std::string& arguments) {
    const Outcome outcome = run(folder, arguments + ' ' + option);
    EXPECT_EQ(outcome.status, 2) << arguments << ' ' << option << '\n' << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    const std::string name = option.substr(0, option.find(' '));
    EXPECT_NE(outcome.err.find(name), std::string::npos) << "no " << name << " in " << outcome.err;
    for (const char* output : {"o.png", "o.mp4", "o.wav", "o.html", "o.json", "tabs", "cpp"})
      EXPECT_FALSE(std::filesystem::exists(folder / output)) << arguments << ' ' << option;
  }

  ScratchFolder folder;
};

TEST_F(RefusedOptions, OfASoundThatHasNoFrames) {
  for (const char* option :
       {"--frames 10", "--size 8x8", "--fps 30", "--mouse 1,1", "--keys a", "--pass image", "--vr", "--mute",
        "--precise", "--crf 1", "--chroma 444", "--tile 0,0,1,1"})
    refuses(option, "render toy --on cpu -o o.wav");
}

TEST_F(RefusedOptions, OfAPictureThatIsNoVideo) {
  for (const char* option : {"--duration 3", "--crf 1", "--chroma 444", "--chroma 420"})
    refuses(option, "render a.glsl -o o.png");
  refuses("--duration 3", "render a.glsl --frames 2 -o o.mp4");
}

TEST_F(RefusedOptions, OfTheTwinOnAnOpenGlPlayer) {
  for (const char* option : {"--tile 0,0,1,1", "--timeout 1"}) {
    refuses(option, "render a.glsl -o o.png");
    refuses(option, "compare a.glsl --on egl --on cpu");
    refuses(option, "view a.glsl");
  }
}

TEST_F(RefusedOptions, TilesOfAPassThatIsDrawnWhole) {
  folder.write("toy/buffer_a.glsl", plain);
  refuses("--tile 0,0,1,1", "render toy --on cpu --pass buffera -o o.png");
}

TEST_F(RefusedOptions, OfCheckWhichLooksAtTheTextAsItIs) {
  for (const char* option : {"--precise", "--init raw", "--pass image", "--tile 0,0,1,1", "--on cpu"})
    refuses(option, "check a.glsl");
}

TEST_F(RefusedOptions, OfDebugWhichWritesNothing) {
  for (const char* option : {"--json r.json", "--timeout 1", "--tile 0,0,1,1"})
    refuses(option, "debug a.glsl --pixel 0,0");
}

TEST_F(RefusedOptions, OfAnExportThatTheyDoNotReach) {
  for (const std::string form : {"json -o o.json", "tabs -o tabs"})
    for (const char* option : {"--init raw", "--vr", "--mute", "--vscode-quirks", "--precise", "--size 8x8"})
      refuses(option, "export a.glsl --to " + form);
  for (const char* option : {"--mute", "--vscode-quirks", "--precise"})
    refuses(option, "export a.glsl --to cpp -o cpp");
  for (const char* option : {"--precise", "--size 8x8"}) refuses(option, "export a.glsl --to html -o o.html");
}

TEST_F(RefusedOptions, OfOtherProjectsThanTheOneAtHand) {
  refuses("--media .", "render a.glsl -o o.png");
  refuses("--media .", "check toy");
  refuses("--vscode-quirks", "render toy -o o.png");
  refuses("--vscode-quirks", "check toy");
}

}  // namespace
}  // namespace shadertwin
