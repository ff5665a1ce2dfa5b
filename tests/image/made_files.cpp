#include "tests/image/made_files.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace shadertwin {

namespace fs = std::filesystem;

void write_bytes(const fs::path& file, const Bytes& bytes) {
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
}

Bytes read_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void cut_file(const fs::path& file, const fs::path& cut, std::size_t size) {
  Bytes bytes = read_bytes(file);
  bytes.resize(size);
  write_bytes(cut, bytes);
}

namespace {

void append(Bytes& to, const Bytes& bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}

void append32(Bytes& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t crc32(const Bytes& bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  }
  return ~crc;
}

// RFC 1950 around one stored block of RFC 1951.
Bytes zlib_stored(const Bytes& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(bytes.size());
  const auto inverse = static_cast<std::uint16_t>(~size);
  Bytes stream = {0x78, 0x01, 0x01};
  for (const std::uint16_t value : {size, inverse}) {
    stream.push_back(static_cast<std::uint8_t>(value & 0xff));
    stream.push_back(static_cast<std::uint8_t>(value >> 8));
  }
  append(stream, bytes);
  append32(stream, b << 16 | a);
  return stream;
}

void append_chunk(Bytes& to, const std::string& type, const Bytes& data) {
  append32(to, static_cast<std::uint32_t>(data.size()));
  Bytes checked(type.begin(), type.end());
  append(checked, data);
  append(to, checked);
  append32(to, crc32(checked));
}

}  // namespace

Bytes encode(const Png& png) {
  Bytes header;
  append32(header, png.width);
  append32(header, png.height);
  append(header, {png.bits, png.colour, 0, 0, 0});
  Bytes pixels;
  for (const Bytes& row : png.rows) {
    pixels.push_back(0);  // no filter
    append(pixels, row);
  }
  if (pixels.size() > 65535) throw std::logic_error("one stored block holds no more");

  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  append_chunk(file, "IHDR", header);
  if (!png.palette.empty()) append_chunk(file, "PLTE", png.palette);
  if (!png.transparency.empty()) append_chunk(file, "tRNS", png.transparency);
  append_chunk(file, "IDAT", zlib_stored(pixels));
  append_chunk(file, "IEND", {});
  return file;
}

void write_picture(const fs::path& file, const OIIO::ImageSpec& spec, const std::vector<float>& values) {
  OIIO::ImageSpec unassociated = spec;
  unassociated.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(file.string());
  if (!output || !output->open(file.string(), unassociated) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !output->close())
    throw std::runtime_error(file.string() + ": " + (output ? output->geterror() : OIIO::geterror()));
}

}  // namespace shadertwin
