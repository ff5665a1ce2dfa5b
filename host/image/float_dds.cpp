#include "host/image/float_dds.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "host/image/formats.h"

namespace shadertwin {

namespace {

static_assert(std::endian::native == std::endian::little, "the file's byte order");

constexpr std::size_t header_size = 128;     // with the four letters in front
constexpr std::size_t extended_size = 20;    // what "DX10" adds
constexpr std::uint32_t has_four_cc = 0x4;   // in the flags of the pixel format
constexpr std::uint32_t two_dimensions = 3;  // D3D10_RESOURCE_DIMENSION_TEXTURE2D

std::uint32_t four_cc(const char (&text)[5]) {
  std::uint32_t code = 0;
  std::memcpy(&code, text, sizeof code);
  return code;
}

// Floats a texel; 0 for another format.
std::size_t channels_of_code(std::uint32_t code) {
  switch (code) {
    case 114:  // D3DFMT_R32F
      return 1;
    case 115:  // D3DFMT_G32R32F
      return 2;
    case 116:  // D3DFMT_A32B32G32R32F
      return 4;
    default:
      return 0;
  }
}

std::size_t channels_of_dxgi(std::uint32_t format) {
  switch (format) {
    case 41:  // DXGI_FORMAT_R32_FLOAT
      return 1;
    case 16:  // DXGI_FORMAT_R32G32_FLOAT
      return 2;
    case 6:  // DXGI_FORMAT_R32G32B32_FLOAT
      return 3;
    case 2:  // DXGI_FORMAT_R32G32B32A32_FLOAT
      return 4;
    default:
      return 0;
  }
}

}  // namespace

std::optional<Texture> read_float_dds(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, header_size + extended_size> header{};
  in.read(header.data(), header_size);
  if (in.gcount() != header_size || std::memcmp(header.data(), "DDS ", 4) != 0) return std::nullopt;
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &header[at], sizeof value);
    return value;
  };
  if ((word(80) & has_four_cc) == 0) return std::nullopt;
  std::size_t channels = channels_of_code(word(84));
  if (word(84) == four_cc("DX10")) {
    in.read(&header[header_size], extended_size);
    if (in.gcount() != extended_size) fail_to_read(file, "the file breaks off");
    if (word(header_size + 4) == two_dimensions) channels = channels_of_dxgi(word(header_size));
  }
  if (channels == 0) return std::nullopt;

  const std::uint32_t height = word(12);
  const std::uint32_t width = word(16);
  constexpr auto most = static_cast<std::uint32_t>(max_extent);
  if (width < 1 || height < 1 || width > most || height > most)
    fail_to_read(file, "is " + std::to_string(width) + "x" + std::to_string(height) +
                           " texels large; from 1x1 to " + std::to_string(max_extent) + "x" +
                           std::to_string(max_extent) + " can be read");
  // Before memory is taken for what a header only claims.
  const std::size_t texels = std::size_t{width} * height;
  const std::size_t bytes = texels * channels * sizeof(float);
  std::error_code failed;
  const auto start = static_cast<std::size_t>(in.tellg());
  if (std::filesystem::file_size(file, failed) < start + bytes || failed)
    fail_to_read(file, "the file breaks off");
  std::vector<float> values(texels * channels);
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(bytes));
  if (!in) fail_to_read(file, "the file breaks off");

  Texture texture;
  texture.format = Texture::Format::rgba32f;
  texture.width = static_cast<int>(width);
  texture.height = static_cast<int>(height);
  texture.data.resize(texels * texture.texel_bytes());
  for (std::size_t i = 0; i < texels; ++i) {
    std::array<float, 4> texel = {0.0F, 0.0F, 0.0F, 1.0F};
    std::memcpy(texel.data(), &values[channels * i], channels * sizeof(float));
    std::memcpy(&texture.data[i * sizeof texel], texel.data(), sizeof texel);
  }
  return texture;
}

}  // namespace shadertwin
