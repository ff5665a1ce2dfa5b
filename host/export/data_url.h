// Files as text that stands in a page.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace shadertwin {

// RFC 4648, with padding.
std::string base64(std::span<const std::byte> bytes);

// What a browser calls the kind of file that has this extension ("image/png"); empty for kinds that browsers
// don't decode.
std::string media_type(const std::filesystem::path& file);

// The whole file as "data:TYPE;base64,...". Throws Error(file).
std::string data_url(const std::filesystem::path& file);

}  // namespace shadertwin
