#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/image/formats.h"
#include "host/image/image.h"
#include "host/image/usual_files.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

std::string write_by_openimageio(const PictureToWrite& picture, const fs::path& file) {
  return formats().write(picture, file);
}

struct ImageFormat : OutputFormat {
  bool is_float;  // else a byte a channel
  bool has_alpha;
  std::string (*write)(const PictureToWrite& picture, const fs::path& file);
  std::span<const WriterSetting> settings = {};
};

constexpr std::array<WriterSetting, 2> jpeg_settings = {
    {{"Compression", "jpeg:95"}, {"jpeg:subsampling", "4:4:4"}}};
// OpenImageIO would put in the time of day; the same command shall give the same file.
constexpr std::array<WriterSetting, 2> exr_settings = {
    {{"compression", "zip"}, {"DateTime", "1970:01:01 00:00:00"}}};

constexpr std::array<ImageFormat, 4> image_table = {{
    {{".png", "8 bits, as a browser's canvas shows it"}, false, true, write_png},
    {{".jpg", ""}, false, false, write_by_openimageio, jpeg_settings},
    {{".jpeg", ""}, false, false, write_by_openimageio, jpeg_settings},
    {{".exr", "float32 RGBA, bit for bit"}, true, true, write_by_openimageio, exr_settings},
}};

std::vector<std::uint8_t> to_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes(image.rgba.size());
  std::transform(image.rgba.begin(), image.rgba.end(), bytes.begin(), canvas_byte);
  return bytes;
}

bool is_opaque(const std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 3; i < rgba.size(); i += 4)
    if (rgba[i] != 255) return false;
  return true;
}

}  // namespace

// In double, where 255 * value + 0.5 is exact.
std::uint8_t canvas_byte(float value) {
  if (!(value > 0)) return 0;
  return static_cast<std::uint8_t>(std::min(255.0, std::floor(255.0 * value + 0.5)));
}

std::vector<OutputFormat> image_formats() {
  return output_formats(image_table);
}

bool can_write(const fs::path& file) {
  return find_format(image_table, file) != nullptr;
}

void write_image(const Image& image, const fs::path& file) {
  const ImageFormat* const format = find_format(image_table, file);
  if (format == nullptr)
    throw Error(ExitStatus::usage, file.string() + ": pictures are written as " + list_of(image_formats()));
  if (image.width < 1 || image.height < 1)
    throw Error(ExitStatus::file, file.string() + ": the picture is empty");

  PictureToWrite picture{.is_float = format->is_float,
                         .width = image.width,
                         .height = image.height,
                         .rgba = image.rgba.data(),
                         .settings = format->settings};
  std::vector<std::uint8_t> bytes;
  if (!format->is_float) {
    bytes = to_bytes(image);
    picture.channels = format->has_alpha && !is_opaque(bytes) ? 4 : 3;
    picture.rgba = bytes.data();
  }
  OutputFile target(file);
  std::string reason = format->write(picture, target.path());
  if (!reason.empty()) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(ExitStatus::file, file.string() + ": " + reason);
  }
  target.commit();
}

}  // namespace shadertwin
