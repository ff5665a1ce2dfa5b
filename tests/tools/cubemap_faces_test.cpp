// The program as a user calls it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "host/image/image.h"
#include "tests/scratch_folder.h"
#include "tools/cubemap.h"

namespace shadertwin {
namespace {

int run(const std::string& arguments) {
  const int status = std::system((CUBEMAP_FACES " " + arguments + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CubemapFaces, WritesSixFacesThatReadAsACubemap) {
  const ScratchFolder folder;
  Image map(8, 4);
  std::fill(map.rgba.begin(), map.rgba.end(), 0.5f);
  write_image(map, folder / "map.exr");
  ASSERT_EQ(run((folder / "map.exr").string() + " " + (folder / "cube").string() +
                " --size 8 --samples 1 --exposure 1 --format png"),
            0);
  std::vector<std::filesystem::path> faces;
  for (const char* name : face_names) faces.push_back(folder / ("cube_" + std::string(name) + ".png"));
  const Texture cube = read_cubemap(faces, false);
  EXPECT_EQ(cube.width, 8);
  EXPECT_TRUE(
      std::all_of(cube.data.begin(), cube.data.end(), [](std::byte b) { return b == std::byte{255}; }));
}

TEST(CubemapFaces, ReturnsItsErrorsAsTheProgramItselfDoes) {
  const ScratchFolder folder;
  EXPECT_EQ(run((folder / "missing.exr").string() + " " + (folder / "cube").string()), 4);
  EXPECT_NE(run("--size 0 a b"), 0);
  EXPECT_TRUE(folder.is_empty());
}

// The pictures that are committed: square, of one size, small, and without a seam.
TEST(CubemapFaces, TheCommittedOnesFitTogether) {
  for (const std::string place : {"forest", "city"}) {
    std::vector<std::filesystem::path> files;
    for (const char* name : face_names)
      files.emplace_back(SHADERTWIN_SOURCE_DIR "/shadertoy/cubemaps/" + place + "_" + name + ".jpg");
    const Texture cube = read_cubemap(files, false);
    EXPECT_EQ(cube.width, 256);
    const auto texel = [&](int face, int x, int y, int channel) {
      return std::to_integer<int>(
          cube.data[((std::size_t{256} * face + y) * 256 + x) * 4 + static_cast<std::size_t>(channel)]);
    };
    // Left of +Z (face 4) is the right edge of -X (face 1), and so on around; above +Z is the lower edge of
    // +Y.
    double around = 0, above = 0;
    for (int i = 0; i < 256; ++i)
      for (int c = 0; c < 3; ++c) {
        const int ring[] = {1, 4, 0, 5};
        for (int k = 0; k < 4; ++k)
          around += std::abs(texel(ring[k], 255, i, c) - texel(ring[(k + 1) % 4], 0, i, c)) / (4 * 256 * 3.0);
        above += std::abs(texel(2, i, 255, c) - texel(4, i, 0, c)) / (256 * 3.0);
      }
    // Codes of 255, on average; a face out of place gives 20 and more.
    EXPECT_LT(around, 8) << place;
    EXPECT_LT(above, 8) << place;
  }
}

}  // namespace
}  // namespace shadertwin
