#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/image/image.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

enum class FileKind { unknown, exr, png, jpeg };

FileKind kind_of(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".exr") return FileKind::exr;
  if (extension == ".png") return FileKind::png;
  if (extension == ".jpg" || extension == ".jpeg") return FileKind::jpeg;
  return FileKind::unknown;
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

// Writes the first spec.nchannels of four channels, the last row first.
void encode(const fs::path& file, const OIIO::ImageSpec& spec, const void* rgba) {
  const auto texel = static_cast<OIIO::stride_t>(4 * spec.format.size());
  const OIIO::stride_t row = texel * spec.width;
  const auto* const top = static_cast<const char*>(rgba) + row * (spec.height - 1);

  OutputFile target(file);
  CheckedStream stream(target.path());
  const auto output = OIIO::ImageOutput::create(target.path().string(), &stream);
  std::string reason;
  if (stream.failure() != 0) {
    // nothing to write to
  } else if (!output) {
    reason = OIIO::geterror();
  } else {
    const bool written =
        output->open(target.path().string(), spec) && output->write_image(spec.format, top, texel, -row);
    if (!output->close() || !written) reason = output->geterror();
    if (reason.empty() && !written) reason = "can't be written";
  }
  stream.close();
  if (stream.failure() != 0) reason = std::strerror(stream.failure());
  if (!reason.empty()) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(ExitStatus::file, file.string() + ": " + reason);
  }
  target.commit();
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

  if (kind == FileKind::exr) {
    OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    // OpenImageIO would put in the time of day; the same command shall give the same file.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    encode(file, spec, image.rgba.data());
    return;
  }
  const std::vector<std::uint8_t> bytes = to_bytes(image);
  const int channels = kind == FileKind::png && !is_opaque(bytes) ? 4 : 3;
  OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (kind == FileKind::jpeg) {
    spec.attribute("Compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  encode(file, spec, bytes.data());
}

}  // namespace shadertwin
