#include "host/media/riff.h"

#include <array>
#include <fstream>
#include <string_view>

namespace shadertwin::media {

namespace {

struct Chunk {
  std::array<unsigned char, 8> bytes{};

  bool is(std::string_view name) const {
    return name == std::string_view(reinterpret_cast<const char*>(bytes.data()), 4);
  }
  std::uint32_t size() const {
    return bytes[4] | bytes[5] << 8 | bytes[6] << 16 | static_cast<std::uint32_t>(bytes[7]) << 24;
  }
  bool read(std::ifstream& stream) {
    return static_cast<bool>(stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size()));
  }
};

constexpr std::uint32_t open_end = 0xffffffff;

}  // namespace

std::uint64_t missing_riff_bytes(const std::filesystem::path& file) {
  std::error_code problem;
  const std::uintmax_t length = std::filesystem::file_size(file, problem);
  std::ifstream stream(file, std::ios::binary);
  Chunk chunk;
  if (problem || !chunk.read(stream) || !chunk.is("RIFF")) return 0;
  std::uint64_t at = 12;  // behind "WAVE"
  for (stream.seekg(12); chunk.read(stream); stream.seekg(static_cast<std::streamoff>(at))) {
    const std::uint64_t end = at + 8 + chunk.size();
    if (chunk.is("data")) return end > length && chunk.size() != open_end ? end - length : 0;
    at = end + (chunk.size() & 1U);
  }
  return 0;
}

}  // namespace shadertwin::media
