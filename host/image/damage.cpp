#include "host/image/damage.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace shadertwin {

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes read_all(std::ifstream& in) {
  in.seekg(0, std::ios::end);
  Bytes bytes(static_cast<std::size_t>(in.tellg()));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
         bytes[3];
}

// CRC-32 as PNG has it (ISO/IEC 15948 annex D).
std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int bit = 0; bit < 8; ++bit) table[i] = (table[i] >> 1) ^ ((table[i] & 1) != 0 ? 0xedb88320u : 0u);
  }
  return table;
}

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size) {
  static const auto table = make_crc_table();
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) crc = (crc >> 8) ^ table[(crc ^ bytes[i]) & 255];
  return ~crc;
}

constexpr char truncated[] = "the picture is truncated";

// Walks the chunks to IEND (ISO/IEC 15948 section 5.3): length, type, data, checksum of type and data.
std::string find_png_damage(const Bytes& bytes) {
  std::size_t at = 8;
  while (at + 12 <= bytes.size()) {
    const std::uint8_t* const chunk = &bytes[at];
    const std::size_t length = big_endian(chunk);
    if (length > bytes.size() - at - 12) return truncated;
    if (big_endian(chunk + 8 + length) != crc32(chunk + 4, length + 4)) return "the picture is damaged";
    if (std::memcmp(chunk + 4, "IHDR", 4) == 0 && length >= 8 &&
        (big_endian(chunk + 8) == 0 || big_endian(chunk + 12) == 0))
      return "the picture is empty";
    if (std::memcmp(chunk + 4, "IEND", 4) == 0) return "";
    at += length + 12;
  }
  return truncated;
}

// Walks the segments to EOI (ITU-T T.81 annex B). Segments are skipped by their length, so that the end of an
// embedded thumbnail doesn't count.
std::string find_jpeg_damage(const Bytes& bytes) {
  constexpr std::uint8_t restart_first = 0xd0, restart_last = 0xd7, end_of_image = 0xd9, start_of_scan = 0xda;
  std::size_t at = 2;
  while (at + 1 < bytes.size()) {
    const std::uint8_t marker = bytes[at + 1];
    if (bytes[at] != 0xff || marker == 0xff) {
      ++at;  // fill bytes
      continue;
    }
    if (marker == end_of_image) return "";
    if (at + 3 >= bytes.size()) return truncated;
    at += 2 + (std::size_t{bytes[at + 2]} << 8 | bytes[at + 3]);
    if (marker != start_of_scan) continue;
    for (; at + 1 < bytes.size(); ++at) {
      const std::uint8_t next = bytes[at + 1];
      const bool inside_scan = next == 0 || next == 0xff || (next >= restart_first && next <= restart_last);
      if (bytes[at] == 0xff && !inside_scan) break;
    }
  }
  return truncated;
}

}  // namespace

std::string find_damage(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint8_t start[8] = {};
  in.read(reinterpret_cast<char*>(start), sizeof start);
  in.clear();
  if (std::memcmp(start, "\x89PNG\r\n\x1a\n", 8) == 0) return find_png_damage(read_all(in));
  if (start[0] == 0xff && start[1] == 0xd8 && start[2] == 0xff) return find_jpeg_damage(read_all(in));
  return "";
}

}  // namespace shadertwin
