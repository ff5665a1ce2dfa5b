// A short name for a long text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace shadertwin {

// 32 hexadecimal digits: two FNV-1a hashes (http://www.isthe.com/chongo/tech/comp/fnv/) with different
// starts.
inline std::string hash_name(std::string_view text) {
  std::string name;
  for (const std::uint64_t start : {0xcbf29ce484222325ULL, 0x9ae16a3b2f90404fULL}) {
    std::uint64_t hash = start;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    for (int shift = 60; shift >= 0; shift -= 4) name += "0123456789abcdef"[hash >> shift & 15];
  }
  return name;
}

}  // namespace shadertwin
