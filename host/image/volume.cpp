#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "host/base/error.h"
#include "host/image/image.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t header_bytes = 20;
constexpr std::uint32_t max_volume_extent = 2048;
constexpr std::array<unsigned char, 4> signature = {'B', 'I', 'N', 0};

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw Error(ExitStatus::file, file.string() + ": " + reason);
}

struct Header {
  std::array<unsigned char, 4> signature;
  std::array<std::uint32_t, 3> size;  // little-endian, as all of the file
  std::uint8_t channels;
  std::uint8_t layout;  // unused
  std::uint16_t format;
};
static_assert(sizeof(Header) == header_bytes);

// Values of T to RGBA; green and blue that are not there are 0, alpha is `one`.
template <class T>
std::vector<std::byte> spread(const std::vector<char>& data, std::size_t texels, std::size_t channels,
                              T one) {
  std::vector<std::byte> rgba(texels * 4 * sizeof(T));
  for (std::size_t i = 0; i < texels; ++i) {
    std::array<T, 4> texel{T{}, T{}, T{}, one};
    std::memcpy(texel.data(), &data[i * channels * sizeof(T)], channels * sizeof(T));
    std::memcpy(&rgba[i * sizeof texel], texel.data(), sizeof texel);
  }
  return rgba;
}

}  // namespace

Texture read_volume(const fs::path& file) {
  std::error_code problem;
  if (fs::is_directory(file, problem)) fail(file, "is a folder, not a volume");
  const std::uintmax_t bytes = fs::file_size(file, problem);
  if (problem) fail(file, problem.message());
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file, std::strerror(errno));
  Header header{};
  if (bytes < header_bytes || !stream.read(reinterpret_cast<char*>(&header), header_bytes) ||
      header.signature != signature)
    fail(file, "not a volume as shadertoy.com has them (BIN, size, channels, texels)");
  std::string shape;
  std::uintmax_t texels = 1;
  for (const std::uint32_t extent : header.size) {
    shape += (shape.empty() ? "" : "x") + std::to_string(extent);
    texels *= extent;
  }
  for (const std::uint32_t extent : header.size)
    if (extent < 1 || extent > max_volume_extent)
      fail(file, "the volume is " + shape + "; 1 to " + std::to_string(max_volume_extent) +
                     " is possible each way");
  if (header.channels < 1 || header.channels > 4)
    fail(file, "the volume has " + std::to_string(header.channels) + " channels, not 1 to 4");
  if (header.format != 0 && header.format != 10)
    fail(file, "the volume's texels have the unknown format " + std::to_string(header.format));
  const bool is_float = header.format == 10;
  const std::uintmax_t expected = texels * header.channels * (is_float ? sizeof(float) : 1);
  if (bytes - header_bytes != expected)
    fail(file, "a volume of " + shape + " texels with " + std::to_string(header.channels) + " channel" +
                   (header.channels == 1 ? "" : "s") + " takes " + std::to_string(expected + header_bytes) +
                   " bytes, but the file has " + std::to_string(bytes));
  std::vector<char> data(static_cast<std::size_t>(expected));
  if (!stream.read(data.data(), static_cast<std::streamsize>(data.size())))
    fail(file, "can't be read to its end");

  Texture volume;
  volume.is_volume = true;
  volume.format = is_float ? Texture::Format::rgba32f : Texture::Format::rgba8;
  volume.width = static_cast<int>(header.size[0]);
  volume.height = static_cast<int>(header.size[1]);
  volume.depth = static_cast<int>(header.size[2]);
  const auto count = static_cast<std::size_t>(texels);
  volume.data = is_float ? spread<float>(data, count, header.channels, 1.0F)
                         : spread<std::uint8_t>(data, count, header.channels, 255);
  return volume;
}

}  // namespace shadertwin
