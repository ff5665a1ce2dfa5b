// PNG and JPEG as nearly all of them are, without the libraries that OpenImageIO brings along.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/image/formats.h"
#include "host/image/image.h"

namespace shadertwin {

// The same texels that OpenImageIO gives, row 0 the top row. Nothing for any other file: one with more than 8
// bits, with CMYK, with metadata that turn it, one that is too large or can't be decoded.
std::optional<Texture> read_usual(const std::filesystem::path& file);

// Writes a PNG of 8 bits. Why the file could not be written; empty if it was.
std::string write_png(const PictureToWrite& picture, const std::filesystem::path& file);

}  // namespace shadertwin
