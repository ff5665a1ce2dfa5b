// The library libshadertwin_pictures.so.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "host/base/error.h"
#include "host/image/formats.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

std::unique_ptr<OIIO::ImageInput> open_picture(const fs::path& file) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // or colours are multiplied by alpha
  auto input = OIIO::ImageInput::open(file.string(), &config);
  if (!input) fail_to_read(file, "not a picture that can be read (" + OIIO::geterror() + ")");
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
    fail_to_read(file, "can't be read to its end (" + input.geterror() + ")");

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

Texture read(const fs::path& file) try {
  const auto input = open_picture(file);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail_to_read(file, "the picture is empty");
  if (spec.width > max_extent || spec.height > max_extent)
    fail_to_read(file, "the picture is " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
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
  fail_to_read(file, "not enough memory for the picture");
}

// Bytes on their way to a file. The first failure is kept here and hidden from the encoders: libjpeg would
// end the process, and others don't look.
class CheckedStream : public OIIO::Filesystem::IOProxy {
 public:
  explicit CheckedStream(const fs::path& file)
      : IOProxy(file.string(), Write), stream_(std::fopen(file.c_str(), "wb")) {
    if (!stream_) note_failure();
  }
  ~CheckedStream() override { CheckedStream::close(); }
  CheckedStream(const CheckedStream&) = delete;
  CheckedStream& operator=(const CheckedStream&) = delete;

  // Not "file": OpenImageIO would take this for its own class of that kind.
  const char* proxytype() const override { return "checked"; }
  void close() override {
    if (stream_ && std::fclose(stream_) != 0) note_failure();
    stream_ = nullptr;
  }
  int64_t tell() override { return stream_ ? ftello(stream_) : 0; }
  bool seek(int64_t offset) override {
    if (!stream_ || fseeko(stream_, offset, SEEK_SET) != 0) note_failure();
    return true;
  }
  size_t write(const void* bytes, size_t size) override {
    if (failure_ == 0 && std::fwrite(bytes, 1, size, stream_) < size) note_failure();
    return size;
  }

  // errno of the first operation that failed, 0 if none did.
  int failure() const { return failure_; }

 private:
  void note_failure() {
    if (failure_ == 0) failure_ = errno != 0 ? errno : EIO;
  }

  std::FILE* stream_;
  int failure_ = 0;
};

OIIO::ImageSpec spec_of(const PictureToWrite& picture) {
  OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                       picture.is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!picture.is_float) spec.attribute("oiio:ColorSpace", "sRGB");
  for (const auto& [name, value] : picture.settings) spec.attribute(name, value);
  return spec;
}

std::string write(const PictureToWrite& picture, const fs::path& file) {
  const OIIO::ImageSpec spec = spec_of(picture);
  const auto texel = static_cast<OIIO::stride_t>(4 * spec.format.size());
  const OIIO::stride_t row = texel * spec.width;
  const auto* const top = static_cast<const char*>(picture.rgba) + row * (spec.height - 1);

  CheckedStream stream(file);
  const auto output = OIIO::ImageOutput::create(file.string(), &stream);
  std::string reason;
  if (stream.failure() != 0) {
    // nothing to write to
  } else if (!output) {
    reason = OIIO::geterror();
  } else {
    const bool written =
        output->open(file.string(), spec) && output->write_image(spec.format, top, texel, -row);
    if (!output->close() || !written) reason = output->geterror();
    if (reason.empty() && !written) reason = "can't be written";
  }
  stream.close();
  if (stream.failure() != 0) reason = std::strerror(stream.failure());
  return reason;
}

}  // namespace
}  // namespace shadertwin

const shadertwin::Formats* shadertwin_formats() {
  static constexpr shadertwin::Formats functions{shadertwin::read, shadertwin::write};
  return &functions;
}
