// What a .wav says of its own length. libav takes such a file for as long as it is.
#pragma once

#include <cstdint>
#include <filesystem>

namespace shadertwin::media {

// How many bytes of samples the header of a RIFF file promises beyond the end of the file. 0 for any other
// file, and for a header that leaves its length open, as writers into a pipe do.
std::uint64_t missing_riff_bytes(const std::filesystem::path& file);

}  // namespace shadertwin::media
