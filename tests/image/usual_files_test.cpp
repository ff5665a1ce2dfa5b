#include "host/image/usual_files.h"

#include <gtest/gtest.h>

#include "host/image/formats.h"
#include "tests/image/made_files.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

std::vector<float> noise(std::size_t count) {
  std::vector<float> values(count);
  std::uint32_t state = 1;
  for (float& value : values) {
    state = state * 1664525U + 1013904223U;
    value = static_cast<float>(state >> 24U) / 255.0F;
  }
  return values;
}

void expect_same_texels(const std::filesystem::path& file) {
  const std::optional<Texture> usual = read_usual(file);
  ASSERT_TRUE(usual.has_value()) << file;
  const Texture other = formats().read(file);
  EXPECT_EQ(usual->width, other.width);
  EXPECT_EQ(usual->height, other.height);
  EXPECT_EQ(usual->format, other.format);
  EXPECT_TRUE(usual->data == other.data) << file;
}

TEST(UsualFiles, HaveTheTexelsThatOpenImageIoReads) {
  const ScratchFolder folder;
  for (const char* extension : {".png", ".jpg"})
    for (const int channels : {1, 2, 3, 4}) {
      if (std::string(extension) == ".jpg" && channels % 2 == 0) continue;
      const auto file = folder / ("a" + std::to_string(channels) + extension);
      OIIO::ImageSpec spec(37, 23, channels, OIIO::TypeDesc::UINT8);
      if (channels % 2 == 0) spec.alpha_channel = channels - 1;
      spec.attribute("oiio:UnassociatedAlpha", 1);
      write_picture(file, spec, noise(std::size_t{37} * 23 * static_cast<std::size_t>(channels)));
      expect_same_texels(file);
    }
}

TEST(UsualFiles, HaveTheTexelsOfPalettesAndFewBitsToo) {
  const ScratchFolder folder;
  const Png png{
      4, 2, 2, png_palette, {10, 20, 30, 200, 100, 50, 0, 255, 0, 7, 7, 7}, {255, 128}, {{0x1b}, {0xe4}}};
  write_bytes(folder / "palette.png", encode(png));
  expect_same_texels(folder / "palette.png");
  const Png grey{8, 1, 1, png_grey, {}, {}, {{0x5a}}};
  write_bytes(folder / "grey.png", encode(grey));
  expect_same_texels(folder / "grey.png");
}

TEST(UsualFiles, LeaveDeepPicturesAndOtherFilesAlone) {
  const ScratchFolder folder;
  const Png deep{1, 1, 16, png_grey, {}, {}, {{0x12, 0x34}}};
  write_bytes(folder / "deep.png", encode(deep));
  EXPECT_FALSE(read_usual(folder / "deep.png").has_value());
  EXPECT_FALSE(read_usual(folder.write("text.png", "no picture")).has_value());
  EXPECT_FALSE(read_usual(folder.write("empty.jpg", "")).has_value());
  EXPECT_FALSE(read_usual(folder.write("start.jpg", "\xff\xd8\xff\xe0\x00\x10JFIF")).has_value());
}

}  // namespace
}  // namespace shadertwin
