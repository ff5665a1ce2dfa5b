#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "host/base/error.h"
#include "host/image/image.h"
#include "tests/image/made_files.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

// Every kind of float, -0, denormals, infinities and NaNs with payloads, signalling ones too.
Image any_bits(int width, int height) {
  Image image(width, height);
  std::mt19937 random(7);
  for (float& value : image.rgba) {
    const std::uint32_t bits = random();
    std::memcpy(&value, &bits, sizeof value);
  }
  const std::uint32_t special[] = {0x00000000u, 0x80000000u, 0x00000001u, 0x807fffffu,
                                   0x7f800000u, 0xff800000u, 0x7fc00000u, 0x7f800001u,
                                   0xffc12345u, 0x7fffffffu, 0x3f800000u, 0x7f7fffffu};
  std::memcpy(image.rgba.data(), special, sizeof special);
  return image;
}

std::uint8_t png_byte(const ScratchFolder& folder, float value) {
  Image image(1, 1);
  image.rgba = {value, 0, 0, 1};
  write_image(image, folder / "byte.png");
  return std::to_integer<std::uint8_t>(read_texture(folder / "byte.png", false).data[0]);
}

ExitStatus write_status(const Image& image, const fs::path& file, std::string* text = nullptr) {
  try {
    write_image(image, file);
    return ExitStatus::done;
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": ", 0), 0u) << error.what();
    if (text) *text = error.what();
    return error.status();
  }
}

TEST(WriteImage, ExrKeepsEveryBit) {
  const ScratchFolder folder;
  for (const auto& [width, height] : {std::pair(3, 1), std::pair(61, 37)}) {
    const Image image = any_bits(width, height);
    write_image(image, folder / "bits.exr");
    const Image again = read_image(folder / "bits.exr");
    ASSERT_EQ(again.width, width);
    ASSERT_EQ(again.height, height);
    EXPECT_EQ(std::memcmp(again.rgba.data(), image.rgba.data(), image.rgba.size() * sizeof(float)), 0);
  }
}

TEST(WriteImage, ExrLeavesColourAloneWhereAlphaIsZero) {
  const ScratchFolder folder;
  Image image(1, 1);
  image.rgba = {0.25f, 7.0f, -3.0f, 0.0f};
  write_image(image, folder / "a.exr");
  EXPECT_EQ(read_image(folder / "a.exr").rgba, image.rgba);
}

TEST(WriteImage, PngPutsTheBottomRowLast) {
  const ScratchFolder folder;
  Image image(1, 2);
  image.rgba = {1, 0, 0, 1, 0, 1, 0, 1};  // red below green
  write_image(image, folder / "a.png");
  const Texture top_down = read_texture(folder / "a.png", false);
  EXPECT_EQ(std::to_integer<int>(top_down.data[1]), 255);
  EXPECT_EQ(std::to_integer<int>(top_down.data[4]), 255);
  EXPECT_EQ(read_image(folder / "a.png").rgba, image.rgba);
}

TEST(WriteImage, PngRoundsAsACanvasDoes) {
  const ScratchFolder folder;
  EXPECT_EQ(png_byte(folder, 0.5f), 128);
  EXPECT_EQ(png_byte(folder, 0.499f), 127);
  EXPECT_EQ(png_byte(folder, std::nextafter(0.5f / 255.0f, 0.0f)), 0);
  EXPECT_EQ(png_byte(folder, std::nextafter(0.5f / 255.0f, 1.0f)), 1);
  for (int byte = 0; byte < 256; ++byte) EXPECT_EQ(png_byte(folder, byte / 255.0f), byte);
}

TEST(WriteImage, PngClampsAndMakesNanBlack) {
  const ScratchFolder folder;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(png_byte(folder, -1.0f), 0);
  EXPECT_EQ(png_byte(folder, -infinity), 0);
  EXPECT_EQ(png_byte(folder, 2.0f), 255);
  EXPECT_EQ(png_byte(folder, 3e38f), 255);
  EXPECT_EQ(png_byte(folder, infinity), 255);
  EXPECT_EQ(png_byte(folder, std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(png_byte(folder, -std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(WriteImage, PngHasAlphaOnlyWhereItSaysSomething) {
  const ScratchFolder folder;
  Image image(2, 1);
  image.rgba = {1, 0.5f, 0.25f, 1, 0, 0, 0, 1};
  write_image(image, folder / "a.png");
  EXPECT_EQ(OIIO::ImageInput::open((folder / "a.png").string())->spec().nchannels, 3);
  image.rgba[7] = 0.5f;
  write_image(image, folder / "a.png");
  EXPECT_EQ(OIIO::ImageInput::open((folder / "a.png").string())->spec().nchannels, 4);
}

TEST(WriteImage, PngDoesNotMultiplyByAlpha) {
  const ScratchFolder folder;
  Image image(2, 1);
  image.rgba = {1, 128 / 255.0f, 0, 64 / 255.0f, 1, 1, 1, 0};
  write_image(image, folder / "a.png");
  EXPECT_EQ(read_image(folder / "a.png").rgba, image.rgba);
}

TEST(WriteImage, JpegIsCloseAndUpright) {
  const ScratchFolder folder;
  Image image(32, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const float texel[4] = {x / 31.0f, y / 15.0f, 0.5f, 0.25f};
      std::memcpy(image.at(x, y), texel, sizeof texel);
    }
  for (const char* name : {"a.jpg", "a.jpeg", "a.JPG"}) {
    write_image(image, folder / name);
    const Image again = read_image(folder / name);
    ASSERT_EQ(again.width, 32);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
      ASSERT_NEAR(again.rgba[i], i % 4 == 3 ? 1.0f : image.rgba[i], 0.03f) << name << " value " << i;
  }
}

TEST(WriteImage, TheSamePictureGivesTheSameFile) {
  const ScratchFolder folder;
  const Image image = any_bits(16, 16);
  for (const std::string extension : {".exr", ".png", ".jpg"}) {
    write_image(image, folder / ("a" + extension));
    // A clock's second passes: nothing of it may be in the file.
    timespec pause{1, 100'000'000};
    nanosleep(&pause, nullptr);
    write_image(image, folder / ("b" + extension));
    EXPECT_EQ(read_bytes(folder / ("a" + extension)), read_bytes(folder / ("b" + extension))) << extension;
  }
}

TEST(WriteImage, KnowsItsExtensions) {
  for (const char* name : {"a.png", "a.PNG", "b/a.exr", "a.jpg", "a.jpeg", "frame_0001.Exr"})
    EXPECT_TRUE(can_write(name)) << name;
  for (const char* name : {"a", "png", ".png", "a.tif", "a.mp4", "a.png.txt", ""})
    EXPECT_FALSE(can_write(name)) << name;
}

TEST(WriteImage, AnotherExtensionIsWrongUsage) {
  const ScratchFolder folder;
  EXPECT_EQ(write_status(Image(1, 1), folder / "a.tif"), ExitStatus::usage);
  EXPECT_EQ(write_status(Image(1, 1), folder / "a"), ExitStatus::usage);
  EXPECT_TRUE(folder.is_empty());
}

TEST(WriteImage, AnEmptyPictureOrPlaceIsAFileError) {
  const ScratchFolder folder;
  EXPECT_EQ(write_status(Image(), folder / "a.png"), ExitStatus::file);
  EXPECT_EQ(write_status(Image(1, 1), folder / "missing/a.png"), ExitStatus::file);
  EXPECT_TRUE(folder.is_empty());
}

// Stands for a full disk: files of this process can't grow past a size.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST(WriteImage, AFullDiskLeavesNothingBehindWhereverItHappens) {
  const Image image = any_bits(64, 64);
  for (const std::string extension : {".exr", ".png", ".jpg"}) {
    const ScratchFolder folder;
    write_image(image, folder / ("whole" + extension));
    const auto whole = fs::file_size(folder / ("whole" + extension));
    fs::remove(folder / ("whole" + extension));
    for (const std::uintmax_t room : {std::uintmax_t{0}, std::uintmax_t{10}, whole / 2, whole - 1}) {
      std::string text;
      ExitStatus status;
      {
        const FileSizeLimit limit(room);
        status = write_status(image, folder / ("a" + extension), &text);
      }
      EXPECT_EQ(status, ExitStatus::file) << extension << " with room for " << room << " of " << whole;
      EXPECT_NE(text.find("File too large"), std::string::npos) << text;
      EXPECT_TRUE(folder.is_empty()) << extension << " with room for " << room << " of " << whole;
    }
    const FileSizeLimit limit(whole);
    EXPECT_EQ(write_status(image, folder / ("a" + extension)), ExitStatus::done) << extension;
  }
}

TEST(WriteImage, AFullDiskLeavesTheOldFile) {
  const ScratchFolder folder;
  write_image(Image(2, 2), folder / "a.png");
  const Bytes old = read_bytes(folder / "a.png");
  {
    const FileSizeLimit limit(100);
    EXPECT_EQ(write_status(any_bits(64, 64), folder / "a.png"), ExitStatus::file);
  }
  EXPECT_EQ(read_bytes(folder / "a.png"), old);
}

}  // namespace
}  // namespace shadertwin
