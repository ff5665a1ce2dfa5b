// The bytes of a .bin volume.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace shadertwin {

inline std::string volume_file(const std::array<std::uint32_t, 3>& size, int channels, int format,
                               const std::string& texels) {
  std::string bytes("BIN\0", 4);
  for (const std::uint32_t extent : size)
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(extent >> shift & 0xff);
  bytes += {static_cast<char>(channels), '\0', static_cast<char>(format), '\0'};
  return bytes + texels;
}

}  // namespace shadertwin
