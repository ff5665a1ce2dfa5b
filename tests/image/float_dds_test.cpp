#include "host/image/float_dds.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "host/base/error.h"
#include "tests/image/made_files.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

// A file of 2x2 texels with `channels` floats 1, 2, 3 ... and a DXGI format, or with the Direct3D 9 code if
// `dxgi` is 0.
Bytes dds(std::size_t channels, std::uint32_t dxgi, std::uint32_t code = 0) {
  const std::size_t start = dxgi == 0 ? 128 : 148;
  Bytes file(start + 4 * channels * sizeof(float));
  const auto put = [&](std::size_t at, std::uint32_t value) { std::memcpy(&file[at], &value, 4); };
  std::memcpy(file.data(), "DDS ", 4);
  put(4, 124);
  put(12, 2);
  put(16, 2);
  put(76, 32);
  put(80, 4);
  put(84, code);
  if (dxgi != 0) {
    std::memcpy(&file[84], "DX10", 4);
    put(128, dxgi);
    put(132, 3);
    put(140, 1);
  }
  std::vector<float> values(4 * channels);
  std::iota(values.begin(), values.end(), 1.0F);
  std::memcpy(&file[start], values.data(), values.size() * sizeof(float));
  return file;
}

std::vector<float> texels(const Texture& texture) {
  EXPECT_EQ(texture.format, Texture::Format::rgba32f);
  std::vector<float> values(texture.data.size() / sizeof(float));
  std::memcpy(values.data(), texture.data.data(), texture.data.size());
  return values;
}

TEST(FloatDds, OneToFourFloatsATexelWithZerosAndAlphaOneForTheRest) {
  const ScratchFolder folder;
  const auto read = [&](const Bytes& file) {
    write_bytes(folder / "t.dds", file);
    return texels(read_texture(folder / "t.dds", false));
  };
  using Values = std::vector<float>;
  EXPECT_EQ(read(dds(1, 41)), (Values{1, 0, 0, 1, 2, 0, 0, 1, 3, 0, 0, 1, 4, 0, 0, 1}));
  EXPECT_EQ(read(dds(2, 16)), (Values{1, 2, 0, 1, 3, 4, 0, 1, 5, 6, 0, 1, 7, 8, 0, 1}));
  EXPECT_EQ(read(dds(3, 6)), (Values{1, 2, 3, 1, 4, 5, 6, 1, 7, 8, 9, 1, 10, 11, 12, 1}));
  const Values all = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  EXPECT_EQ(read(dds(4, 2)), all);
  EXPECT_EQ(read(dds(4, 0, 116)), all);
}

TEST(FloatDds, BrokenOnesAreOneLineAndOthersAreLeftAlone) {
  const ScratchFolder folder;
  const auto error = [&](const Bytes& file) -> std::string {
    write_bytes(folder / "t.dds", file);
    try {
      read_float_dds(folder / "t.dds");
    } catch (const Error& problem) {
      EXPECT_EQ(problem.status(), ExitStatus::file);
      return std::string(problem.what()).substr((folder / "t.dds").string().size());
    }
    return "none";
  };
  Bytes file = dds(4, 2);
  file.pop_back();
  EXPECT_EQ(error(file), ": the file breaks off");
  file.resize(140);
  EXPECT_EQ(error(file), ": the file breaks off");
  file = dds(4, 2);
  file[19] = 1;
  EXPECT_NE(error(file).find("16777218x2"), std::string::npos) << error(file);
  write_bytes(folder / "bc1.dds", dds(4, 71));
  EXPECT_FALSE(read_float_dds(folder / "bc1.dds").has_value());
  write_bytes(folder / "t.png", {1, 2, 3});
  EXPECT_FALSE(read_float_dds(folder / "t.png").has_value());
}

}  // namespace
}  // namespace shadertwin
