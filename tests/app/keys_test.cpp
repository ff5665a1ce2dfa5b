// --keys as a user types it: what the keyboard texture holds from frame to frame.
#include <gtest/gtest.h>

#include <glm/glm.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

// Texel (f, r) of the picture keeps what row r of the key A held in frame f.
std::string history_of(const std::string& keyboard) {
  return "void mainImage(out vec4 c, in vec2 p) {\n  c = texelFetch(iChannel0, ivec2(p), 0);\n"
         "  if (int(p.x) == iFrame) c = texelFetch(" +
         keyboard + ", ivec2(65, int(p.y)), 0);\n}\n";
}

class Keys : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("file.glsl", "#iKeyboard\n#iChannel0 \"self\"\n" + history_of("iKeyboard"));
    folder.write("tabs/image.glsl",
                 "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }\n");
    folder.write("tabs/buffer_a.glsl", history_of("iChannel1"));
    folder.write("tabs/shadertoy.json",
                 R"({"Image": {"iChannel0": {"buffer": "Buffer A"}},
                     "Buffer A": {"iChannel0": {"buffer": "Buffer A"}, "iChannel1": {"keyboard": true}}})");
  }
  // The picture after eight frames.
  Image played(const std::string& shader, const std::string& on) const {
    const Outcome outcome = run(folder, "render " + shader + " --size 8x4 --frames 8 --on " + on +
                                            " --keys a@1-3,a@5-5 --keys a@7 --quiet -o a.exr");
    EXPECT_EQ(outcome.err, "");
    return read_image(folder / "a.exr");
  }
  static std::string row(const Image& image, int y, int channel) {
    std::string text;
    for (int x = 0; x < image.width; ++x) text += std::to_string(std::lround(image.at(x, y)[channel]));
    return text;
  }

  ScratchFolder folder;
};

TEST_F(Keys, AreHeldPressedAndToggledInRedAloneOnTheSite) {
  for (const std::string& on : with_osmesa({"llvmpipe/fragment", "llvmpipe/compute", "cpu"})) {
    const Image image = played("tabs --pass 'Buffer A'", on);
    EXPECT_EQ(row(image, 0, 0), "01100001") << on << ": held";
    EXPECT_EQ(row(image, 1, 0), "01000001") << on << ": pressed; a tap between two frames does not show";
    EXPECT_EQ(row(image, 2, 0), "01111001") << on << ": toggled";
    for (int y = 0; y < 3; ++y) {
      EXPECT_EQ(row(image, y, 1), "00000000") << on;
      EXPECT_EQ(row(image, y, 2), "00000000") << on;
      EXPECT_EQ(row(image, y, 3), "11111111") << on;
    }
  }
}

TEST_F(Keys, AreGreyInTheExtensionWithARowOfReleases) {
  for (const std::string& on : with_osmesa({"llvmpipe/fragment", "llvmpipe/compute", "cpu"})) {
    const Image image = played("file.glsl", on);
    for (const int channel : {0, 1, 2}) {
      EXPECT_EQ(row(image, 0, channel), "01100001") << on << ": held";
      EXPECT_EQ(row(image, 1, channel), "01000101") << on << ": pressed; a tap between two frames, too";
      EXPECT_EQ(row(image, 2, channel), "01111001") << on << ": toggled";
      EXPECT_EQ(row(image, 3, channel), "00010100") << on << ": released";
    }
    for (int y = 0; y < 4; ++y) EXPECT_EQ(row(image, y, 3), "11111111") << on;
  }
}

}  // namespace
}  // namespace shadertwin
