#include "host/image/usual_files.h"

#include <jpeglib.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "host/image/formats.h"

namespace shadertwin {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
using Row = std::uint8_t*;

// The libraries report errors by a jump, which must not pass over a C++ object: what has to be freed lives in
// the caller.
struct Decoded {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::uint8_t> values;
  std::vector<Row> rows;

  bool resize(std::uint32_t w, std::uint32_t h, int c) {
    constexpr auto most = static_cast<std::uint32_t>(max_extent);
    if (w < 1 || h < 1 || w > most || h > most) return false;
    width = static_cast<int>(w);
    height = static_cast<int>(h);
    channels = c;
    values.resize(std::size_t{w} * h * static_cast<std::size_t>(c));
    for (std::uint32_t y = 0; y < h; ++y)
      rows.push_back(values.data() + std::size_t{y} * w * static_cast<std::size_t>(c));
    return true;
  }
};

void quiet(png_structp, png_const_charp) {}
void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool decode_png(PngReader& reader, std::FILE* file, Decoded& decoded) {
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, quiet);
  if (reader.png == nullptr) return false;
  reader.info = png_create_info_struct(reader.png);
  if (reader.info == nullptr || setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_init_io(reader.png, file);
  png_read_info(reader.png, reader.info);
  if (png_get_bit_depth(reader.png, reader.info) > 8 ||
      png_get_valid(reader.png, reader.info, PNG_INFO_eXIf) != 0)
    return false;
  png_set_expand(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  if (!decoded.resize(png_get_image_width(reader.png, reader.info),
                      png_get_image_height(reader.png, reader.info),
                      png_get_channels(reader.png, reader.info)))
    return false;
  png_read_image(reader.png, decoded.rows.data());
  png_read_end(reader.png, nullptr);
  return true;
}

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

bool encode_png(PngWriter& writer, std::FILE* file, const PictureToWrite& picture, Row* rows) {
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, quiet);
  if (writer.png == nullptr) return false;
  writer.info = png_create_info_struct(writer.png);
  if (writer.info == nullptr || setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_init_io(writer.png, file);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), 8,
               picture.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  // Four bytes a pixel are given; of an opaque picture the fourth is left out.
  if (picture.channels == 3) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
  png_write_image(writer.png, rows);
  png_write_end(writer.png, nullptr);
  return true;
}

struct JpegReader {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf leave{};
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
};

// The number of `size` bytes at `at`, in the byte order of an Exif block.
std::uint32_t exif_number(const std::uint8_t* data, std::size_t at, std::size_t size, bool little) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number = number << 8U | data[at + (little ? size - 1 - i : i)];
  return number;
}

// Whether an Exif block says, or might say, that the picture is to be turned (CIPA DC-008, tag 0x0112 of the
// first directory).
bool turns(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t head = 6;  // "Exif" and two zeros
  if (size < head + 8) return true;
  const std::uint8_t* const tiff = data + head;
  const std::size_t length = size - head;
  const bool little = tiff[0] == 'I';
  const std::size_t directory = exif_number(tiff, 4, 4, little);
  if (directory > length || length - directory < 2) return true;
  const std::size_t entries = exif_number(tiff, directory, 2, little);
  if (length - directory - 2 < 12 * entries) return true;
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (exif_number(tiff, entry, 2, little) == 0x0112) return exif_number(tiff, entry + 8, 2, little) != 1;
  }
  return false;
}

bool is_turned(const jpeg_decompress_struct& jpeg) {
  for (const jpeg_marker_struct* marker = jpeg.marker_list; marker != nullptr; marker = marker->next)
    if (marker->marker == JPEG_APP0 + 1 && marker->data_length >= 4 &&
        std::memcmp(marker->data, "Exif", 4) == 0 && turns(marker->data, marker->data_length))
      return true;
  return false;
}

bool decode_jpeg(JpegReader& reader, std::FILE* file, Decoded& decoded) {
  jpeg_decompress_struct& jpeg = reader.jpeg;
  jpeg.err = jpeg_std_error(&reader.errors);
  jpeg.client_data = &reader;
  reader.errors.error_exit = [](j_common_ptr info) {
    std::longjmp(static_cast<JpegReader*>(info->client_data)->leave, 1);
  };
  reader.errors.output_message = [](j_common_ptr) {};
  if (setjmp(reader.leave) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_stdio_src(&jpeg, file);
  jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xffff);
  jpeg_read_header(&jpeg, TRUE);
  if ((jpeg.num_components != 1 && jpeg.num_components != 3) || is_turned(jpeg)) return false;
  jpeg_start_decompress(&jpeg);
  if (!decoded.resize(jpeg.output_width, jpeg.output_height, jpeg.output_components)) return false;
  while (jpeg.output_scanline < jpeg.output_height)
    jpeg_read_scanlines(&jpeg, &decoded.rows[jpeg.output_scanline], 1);
  jpeg_finish_decompress(&jpeg);
  return jpeg.err->num_warnings == 0;
}

Texture to_texture(const Decoded& decoded) {
  Texture texture;
  texture.width = decoded.width;
  texture.height = decoded.height;
  const std::size_t texels =
      static_cast<std::size_t>(decoded.width) * static_cast<std::size_t>(decoded.height);
  const auto channels = static_cast<std::size_t>(decoded.channels);
  const bool grey = channels < 3;
  const bool alpha = channels % 2 == 0;
  texture.data.resize(4 * texels);
  const std::uint8_t* from = decoded.values.data();
  auto* to = reinterpret_cast<std::uint8_t*>(texture.data.data());
  for (std::size_t i = 0; i < texels; ++i, from += channels, to += 4) {
    to[0] = from[0];
    to[1] = from[grey ? 0 : 1];
    to[2] = from[grey ? 0 : 2];
    to[3] = alpha ? from[channels - 1] : 255;
  }
  return texture;
}

}  // namespace

std::optional<Texture> read_usual(const std::filesystem::path& path) {
  const File file(std::fopen(path.c_str(), "rb"), std::fclose);
  std::array<std::uint8_t, 8> start{};
  if (!file || std::fread(start.data(), 1, start.size(), file.get()) != start.size()) return std::nullopt;
  std::rewind(file.get());
  Decoded decoded;
  bool done = false;
  if (png_sig_cmp(start.data(), 0, start.size()) == 0) {
    PngReader reader;
    done = decode_png(reader, file.get(), decoded);
  } else if (start[0] == 0xff && start[1] == 0xd8) {
    JpegReader reader;
    done = decode_jpeg(reader, file.get(), decoded);
  }
  if (!done) return std::nullopt;
  return to_texture(decoded);
}

std::string write_png(const PictureToWrite& picture, const std::filesystem::path& path) {
  std::vector<Row> rows;
  auto* const bottom = static_cast<Row>(const_cast<void*>(picture.rgba));
  for (int y = picture.height - 1; y >= 0; --y)
    rows.push_back(bottom +
                   std::size_t{4} * static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width));
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return std::strerror(errno);
  bool done = false;
  {
    PngWriter writer;
    done = encode_png(writer, file, picture, rows.data());
  }
  std::string reason;
  if (!done || std::fflush(file) != 0) reason = errno != 0 ? std::strerror(errno) : "can't be written";
  if (std::fclose(file) != 0 && reason.empty()) reason = std::strerror(errno);
  return reason;
}

}  // namespace shadertwin
