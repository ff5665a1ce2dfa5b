// The bytes of a .wav of floats.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace shadertwin {

struct WavClaims {
  std::uint32_t rate = 44100;
  int channels = 1;
  std::int64_t data_bytes = -1;  // that the header claims; -1: those that are there
};

inline std::string wav_file(const std::vector<float>& samples, const WavClaims& claims = {}) {
  std::string data(samples.size() * sizeof(float), '\0');
  if (!samples.empty()) std::memcpy(data.data(), samples.data(), data.size());
  const auto size = static_cast<std::uint32_t>(claims.data_bytes < 0 ? static_cast<std::int64_t>(data.size())
                                                                     : claims.data_bytes);
  std::string bytes;
  const auto number = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  };
  const auto frame = static_cast<std::uint32_t>(4 * claims.channels);
  bytes += "RIFF";
  number(36 + size, 4);
  bytes += "WAVEfmt ";
  number(16, 4);
  number(3, 2);  // IEEE floats
  number(static_cast<std::uint32_t>(claims.channels), 2);
  number(claims.rate, 4);
  number(claims.rate * frame, 4);
  number(frame, 2);
  number(32, 2);
  bytes += "data";
  number(size, 4);
  return bytes + data;
}

}  // namespace shadertwin
