#include <algorithm>
#include <cctype>
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

FileKind kind_of(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".exr") return FileKind::exr;
  if (extension == ".png") return FileKind::png;
  if (extension == ".jpg" || extension == ".jpeg") return FileKind::jpeg;
  return FileKind::unknown;
}

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

bool can_write(const fs::path& file) {
  return kind_of(file) != FileKind::unknown;
}

void write_image(const Image& image, const fs::path& file) {
  const FileKind kind = kind_of(file);
  if (kind == FileKind::unknown)
    throw Error(ExitStatus::usage, file.string() + ": pictures are written as .png, .jpg or .exr");
  if (image.width < 1 || image.height < 1)
    throw Error(ExitStatus::file, file.string() + ": the picture is empty");

  PictureToWrite picture{
      .kind = kind, .width = image.width, .height = image.height, .rgba = image.rgba.data()};
  std::vector<std::uint8_t> bytes;
  if (kind != FileKind::exr) {
    bytes = to_bytes(image);
    picture.channels = kind == FileKind::png && !is_opaque(bytes) ? 4 : 3;
    picture.rgba = bytes.data();
  }
  OutputFile target(file);
  std::string reason =
      kind == FileKind::png ? write_png(picture, target.path()) : formats().write(picture, target.path());
  if (!reason.empty()) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(ExitStatus::file, file.string() + ": " + reason);
  }
  target.commit();
}

}  // namespace shadertwin
