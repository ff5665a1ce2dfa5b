// Finds PNG and JPEG files that break off.
#pragma once

#include <filesystem>
#include <string>

namespace shadertwin {

// What is wrong with `file` if it starts as a PNG or a JPEG and is truncated, or is a PNG whose checksums
// don't match; empty otherwise, for other kinds of files too. The libraries that decode these two either take
// such a file for a whole one (libjpeg fills what is missing with grey) or write to stderr themselves
// (libpng).
std::string find_damage(const std::filesystem::path& file);

}  // namespace shadertwin
