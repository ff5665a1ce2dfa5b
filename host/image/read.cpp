#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "host/base/error.h"
#include "host/image/damage.h"
#include "host/image/image.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr int max_extent = 16384;  // what today's GPUs sample

[[noreturn]] void fail(const fs::path& file, std::string reason) {
  while (!reason.empty() && std::isspace(static_cast<unsigned char>(reason.back()))) reason.pop_back();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw Error(ExitStatus::file, file.string() + ": " + reason);
}

std::unique_ptr<OIIO::ImageInput> open_picture(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) fail(file, "is a folder, not a picture");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> probe(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!probe) fail(file, std::strerror(errno));
  if (const std::string damage = find_damage(file); !damage.empty()) fail(file, damage);

  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // or colours are multiplied by alpha
  auto input = OIIO::ImageInput::open(file.string(), &config);
  if (!input) fail(file, "not a picture that can be read (" + OIIO::geterror() + ")");
  return input;
}

// Which of the file's channels each of r, g, b and a is; -1 stands for a constant, 0 for b and 1 for a.
struct ChannelMap {
  int source[4] = {-1, -1, -1, -1};
};

ChannelMap map_channels(const OIIO::ImageSpec& spec) {
  ChannelMap map;
  std::vector<int> colours;
  for (int c = 0; c < spec.nchannels; ++c)
    if (c != spec.alpha_channel && c != spec.z_channel) colours.push_back(c);
  if (colours.size() == 1) colours.assign(3, colours[0]);
  for (std::size_t c = 0; c < std::min<std::size_t>(3, colours.size()); ++c) map.source[c] = colours[c];
  map.source[3] = spec.alpha_channel;
  return map;
}

// Reads the picture as T, in the file's own channels, and hands every value to `convert`.
template <typename T, typename Out, typename Convert>
std::vector<std::byte> read_rgba(OIIO::ImageInput& input, const fs::path& file, OIIO::TypeDesc type, Out one,
                                 Convert convert) {
  const OIIO::ImageSpec spec = input.spec();
  const std::size_t texels = std::size_t(spec.width) * spec.height;
  std::vector<T> values(texels * spec.nchannels);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, values.data()) || input.has_error())
    fail(file, "can't be read to its end (" + input.geterror() + ")");

  const ChannelMap map = map_channels(spec);
  std::vector<std::byte> data(texels * 4 * sizeof(Out));
  for (std::size_t i = 0; i < texels; ++i) {
    Out texel[4] = {Out{}, Out{}, Out{}, one};
    for (int c = 0; c < 4; ++c)
      if (map.source[c] >= 0) texel[c] = convert(values[i * spec.nchannels + map.source[c]]);
    std::memcpy(&data[i * sizeof texel], texel, sizeof texel);
  }
  return data;
}

// Turns the picture as its Orientation says (a camera held upright), as a browser does.
void reorient(Texture& picture, int orientation) {
  if (orientation <= 1 || orientation > 8) return;
  const auto type = picture.format == Texture::Format::rgba8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(picture.width, picture.height, 4, type);
  spec.attribute("Orientation", orientation);
  const OIIO::ImageBuf turned = OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(spec, picture.data.data()));
  std::vector<std::byte> data(picture.data.size());
  turned.get_pixels(turned.roi(), type, data.data());
  picture.data = std::move(data);
  picture.width = turned.spec().width;
  picture.height = turned.spec().height;
}

// Row 0 is the top row.
Texture read_top_down(const fs::path& file) try {
  const auto input = open_picture(file);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail(file, "the picture is empty");
  if (spec.width > max_extent || spec.height > max_extent)
    fail(file, "the picture is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                   "; at most " + std::to_string(max_extent) + " is possible either way");

  Texture picture;
  picture.width = spec.width;
  picture.height = spec.height;
  if (spec.format == OIIO::TypeDesc::UINT8) {
    picture.data = read_rgba<std::uint8_t>(*input, file, OIIO::TypeDesc::UINT8, std::uint8_t{255},
                                           [](std::uint8_t value) { return value; });
  } else {
    picture.format = Texture::Format::rgba32f;
    // OpenImageIO scales by a rounded reciprocal; a division gives the nearest float.
    if (spec.format == OIIO::TypeDesc::UINT16)
      picture.data = read_rgba<std::uint16_t>(*input, file, OIIO::TypeDesc::UINT16, 1.0f,
                                              [](std::uint16_t value) { return float(value) / 65535.0f; });
    else
      picture.data =
          read_rgba<float>(*input, file, OIIO::TypeDesc::FLOAT, 1.0f, [](float value) { return value; });
  }
  reorient(picture, spec.get_int_attribute("Orientation", 1));
  return picture;
} catch (const std::bad_alloc&) {
  fail(file, "not enough memory for the picture");
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
  Texture picture = read_top_down(file);
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
      fail(file, "a face of a cubemap must be square, not " + size_text(picture));
    if (picture.width != pictures[0].width)
      fail(file, "the face is " + size_text(picture) + ", but " + faces[0].string() + " is " +
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
