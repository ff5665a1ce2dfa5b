#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/base/error.h"
#include "host/image/damage.h"
#include "host/image/float_dds.h"
#include "host/image/formats.h"
#include "host/image/image.h"
#include "host/image/usual_files.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

void check_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) fail_to_read(file, "is a folder, not a picture");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> probe(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!probe) fail_to_read(file, std::strerror(errno));
  if (const std::string damage = find_damage(file); !damage.empty()) fail_to_read(file, damage);
}

void flip_rows(Texture& picture) {
  const std::size_t row = picture.width * picture.texel_bytes();
  auto* const data = picture.data.data();
  for (int y = 0; y < picture.height / 2; ++y)
    std::swap_ranges(data + y * row, data + (y + 1) * row, data + (picture.height - 1 - y) * row);
}

// 8 bits to float, as a sampler would see them.
void deepen(Texture& picture) {
  if (picture.format == Texture::Format::rgba32f) return;
  std::vector<std::byte> data(picture.data.size() * sizeof(float));
  for (std::size_t i = 0; i < picture.data.size(); ++i) {
    const float value = std::to_integer<int>(picture.data[i]) / 255.0f;
    std::memcpy(&data[i * sizeof value], &value, sizeof value);
  }
  picture.data = std::move(data);
  picture.format = Texture::Format::rgba32f;
}

std::string size_text(const Texture& picture) {
  return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

}  // namespace

Texture read_texture(const fs::path& file, bool flip) {
  check_file(file);
  std::optional<Texture> usual = read_usual(file);
  if (!usual) usual = read_float_dds(file);
  Texture picture = usual ? *std::move(usual) : formats().read(file);
  if (flip) flip_rows(picture);
  return picture;
}

Texture read_cubemap(const std::vector<fs::path>& faces, bool flip) {
  if (faces.size() != 6)
    throw Error(ExitStatus::file, (faces.empty() ? std::string("cubemap") : faces[0].string()) +
                                      ": a cubemap has six faces, not " + std::to_string(faces.size()));
  std::vector<Texture> pictures;
  bool deep = false;
  for (const fs::path& file : faces) {
    const Texture& picture = pictures.emplace_back(read_texture(file, flip));
    if (picture.width != picture.height)
      fail_to_read(file, "a face of a cubemap must be square, not " + size_text(picture));
    if (picture.width != pictures[0].width)
      fail_to_read(file, "the face is " + size_text(picture) + ", but " + faces[0].string() + " is " +
                             size_text(pictures[0]));
    deep |= picture.format == Texture::Format::rgba32f;
  }
  Texture cube;
  cube.format = deep ? Texture::Format::rgba32f : Texture::Format::rgba8;
  cube.width = cube.height = pictures[0].width;
  cube.faces = 6;
  for (Texture& picture : pictures) {
    if (deep) deepen(picture);
    cube.data.insert(cube.data.end(), picture.data.begin(), picture.data.end());
  }
  return cube;
}

Image read_image(const fs::path& file) {
  Texture picture = read_texture(file, true);
  deepen(picture);
  Image image(picture.width, picture.height);
  std::memcpy(image.rgba.data(), picture.data.data(), picture.data.size());
  return image;
}

}  // namespace shadertwin
