// Volumes as shadertoy.com serves them.
#include <gtest/gtest.h>

#include <cstring>

#include "host/base/error.h"
#include "host/image/image.h"
#include "tests/image/volume_file.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

std::array<int, 4> texel(const Texture& texture, std::size_t i) {
  std::array<int, 4> values{};
  for (std::size_t c = 0; c < 4; ++c) values[c] = std::to_integer<int>(texture.data[4 * i + c]);
  return values;
}

TEST(ReadVolume, OneChannelIsRedXFastest) {
  const ScratchFolder folder;
  const auto file = folder.write("v.bin", volume_file({2, 1, 2}, 1, 0, std::string("\x01\x02\x03\xff", 4)));
  const Texture volume = read_volume(file);
  EXPECT_EQ(volume.width, 2);
  EXPECT_EQ(volume.height, 1);
  EXPECT_EQ(volume.depth, 2);
  EXPECT_TRUE(volume.is_volume);
  EXPECT_EQ(texel(volume, 1), (std::array<int, 4>{2, 0, 0, 255}));
  EXPECT_EQ(texel(volume, 3), (std::array<int, 4>{255, 0, 0, 255}));
}

TEST(ReadVolume, FourChannelsKeepTheirBytes) {
  const ScratchFolder folder;
  const Texture volume = read_volume(folder.write("v.bin", volume_file({1, 1, 1}, 4, 0, "abcd")));
  EXPECT_EQ(texel(volume, 0), (std::array<int, 4>{'a', 'b', 'c', 'd'}));
}

TEST(ReadVolume, FloatsKeepTheirBits) {
  const ScratchFolder folder;
  const std::array<float, 2> values = {-3.5F, 1e30F};
  std::string data(sizeof values, '\0');
  std::memcpy(data.data(), values.data(), data.size());
  const Texture volume = read_volume(folder.write("v.bin", volume_file({1, 1, 1}, 2, 10, data)));
  std::array<float, 4> found{};
  std::memcpy(found.data(), volume.data.data(), sizeof found);
  EXPECT_EQ(found, (std::array<float, 4>{-3.5F, 1e30F, 0.0F, 1.0F}));
}

TEST(ReadVolume, FailsInOneLineOnWhatDoesNotFit) {
  const ScratchFolder folder;
  const std::string whole = volume_file({2, 2, 2}, 1, 0, std::string(8, 'x'));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "not a volume"},
      {whole.substr(0, 19), "not a volume"},
      {"PNG" + whole.substr(3), "not a volume"},
      {whole.substr(0, 27), "takes 28 bytes, but the file has 27"},
      {whole + "y", "takes 28 bytes, but the file has 29"},
      {volume_file({2, 2, 2}, 5, 0, whole), "5 channels"},
      {volume_file({2, 2, 2}, 0, 0, whole), "0 channels"},
      {volume_file({2, 2, 2}, 1, 7, whole), "format 7"},
      {volume_file({2, 0, 2}, 1, 0, ""), "2x0x2"},
      {volume_file({2048, 2048, 2048}, 4, 10, whole), "takes 137438953492 bytes"},
      {volume_file({0xffffffff, 0xffffffff, 0xffffffff}, 4, 10, whole), "4294967295x4294967295"},
  };
  for (const auto& [bytes, words] : cases) {
    const auto file = folder.write("v.bin", bytes);
    try {
      read_volume(file);
      ADD_FAILURE() << words;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), ExitStatus::file);
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_THROW(read_volume(folder.path()), Error);
  EXPECT_THROW(read_volume(folder / "none.bin"), Error);
}

}  // namespace
}  // namespace shadertwin
