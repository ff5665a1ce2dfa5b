// Pictures in memory, and in and out of files through OpenImageIO.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/base/output_format.h"

namespace shadertwin {

// Float32 RGBA pixels. Row 0 is the bottom row, as in OpenGL: pixel (x, y) is the one whose gl_FragCoord is
// (x + 0.5, y + 0.5).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;  // 4 * width * height values

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgba(std::size_t{4} * w * h) {}
  float* at(int x, int y) { return &rgba[(std::size_t{4} * y) * width + std::size_t{4} * x]; }
  const float* at(int x, int y) const { return &rgba[(std::size_t{4} * y) * width + std::size_t{4} * x]; }
};

// What a shader samples: RGBA texels of one precision.
struct Texture {
  enum class Format { rgba8, rgba32f };
  Format format = Format::rgba8;
  int width = 0;
  int height = 0;
  int depth = 1;                // slices of a volume, else 1
  bool is_volume = false;       // sampled in three dimensions, also with one slice
  int faces = 1;                // 6 for a cubemap, in the order +X -X +Y -Y +Z -Z
  std::vector<std::byte> data;  // width * height * depth * faces texels; row 0 is the row at t = 0

  std::size_t texel_bytes() const { return format == Format::rgba8 ? 4 : 16; }
};

// Reads a picture for sampling. 8-bit files give rgba8, every deeper one rgba32f. Missing channels are filled
// as a browser does: grey is spread over r, g and b, and alpha is 1. No colour conversion and no
// premultiplication. flip puts the picture's bottom row at t = 0. Throws Error(file) on a file that is
// missing, truncated, not a picture or more than 16384 texels wide or high.
Texture read_texture(const std::filesystem::path& file, bool flip);

// Reads six faces (+X -X +Y -Y +Z -Z), all of one square size and one precision, the deepest that occurs.
// Throws Error(file).
Texture read_cubemap(const std::vector<std::filesystem::path>& faces, bool flip);

// Reads a volume as shadertoy.com serves them (.bin): 20 bytes of header (BIN\0, three u32 of size, u8
// channels, u8 layout, u16 format: 0 for bytes, 10 for floats), then the texels, x fastest. Green and blue
// that are not there are 0, alpha is 1. Throws Error(file), also for a file of another length than its header
// says.
Texture read_volume(const std::filesystem::path& file);

// Reads any picture as float. Row 0 is the bottom row. Integer formats are scaled to [0, 1]. Throws
// Error(file).
Image read_image(const std::filesystem::path& file);

// What glReadPixels gives of a canvas with 8 bits a channel: clamped to [0, 1], rounded, no conversion of
// colours. NaN is 0.
std::uint8_t canvas_byte(float value);

// Writes a picture, by its extension: .exr keeps float32 RGBA bit for bit; .png is what a browser's canvas
// shows (canvas_byte), with alpha where some pixel's is below 1; .jpg likewise, without alpha, at quality 95.
// The file appears whole or not at all. Throws Error(usage) for another extension, Error(file) when it can't
// be written.
void write_image(const Image& image, const std::filesystem::path& file);

// What write_image writes.
std::vector<OutputFormat> image_formats();
// Whether write_image knows this extension.
bool can_write(const std::filesystem::path& file);

}  // namespace shadertwin
