// Pictures that the tests make themselves, byte by byte where a library would not make them so.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace shadertwin {

using Bytes = std::vector<std::uint8_t>;

void write_bytes(const std::filesystem::path& file, const Bytes& bytes);
Bytes read_bytes(const std::filesystem::path& file);

// Writes the first `size` bytes of `file` to `cut`.
void cut_file(const std::filesystem::path& file, const std::filesystem::path& cut, std::size_t size);

// ISO/IEC 15948 colour types.
enum PngColour : std::uint8_t {
  png_grey = 0,
  png_rgb = 2,
  png_palette = 3,
  png_grey_alpha = 4,
  png_rgba = 6
};

struct Png {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint8_t bits = 8;
  PngColour colour = png_rgba;
  Bytes palette;            // r g b ...
  Bytes transparency;       // the tRNS chunk
  std::vector<Bytes> rows;  // top row first, packed as the format has them
};
Bytes encode(const Png& png);

// Writes `values` (top row first, spec.nchannels a pixel) through OpenImageIO, unchanged.
void write_picture(const std::filesystem::path& file, const OIIO::ImageSpec& spec,
                   const std::vector<float>& values);

}  // namespace shadertwin
