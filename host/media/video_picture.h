// Decoded pictures as textures.
#pragma once

#include <filesystem>
#include <vector>

#include "host/image/image.h"
#include "host/media/libav.h"

namespace shadertwin::media {

// Turns frames into RGBA of 8 bits as browsers do: by the matrix and range that the stream states (without a
// statement BT.709 from 720 rows on, else BT.601), with square pixels, turned as the file says. Transfer
// curves and primaries are left alone.
class VideoConverter {
 public:
  // `flip` puts the bottom row at t = 0.
  explicit VideoConverter(bool flip) : flip_(flip) {}

  // Whose frames come. The picture has the size that the stream states when this is called first. Throws
  // Error(file) for a size that no texture has.
  void set_stream(AVFormatContext& input, const AVStream& stream, const std::filesystem::path& file);
  // Leaves the picture as it is if the frame can't be converted.
  void convert(const AVFrame& frame);
  const Texture& picture() const { return picture_; }

 private:
  void turn(const std::vector<std::byte>& upright);

  bool flip_;
  int width_ = 0;  // before it is turned
  int height_ = 0;
  int quarter_turns_ = 0;  // clockwise
  Scaler scaler_;
  std::vector<std::byte> unturned_;
  Texture picture_;
};

}  // namespace shadertwin::media
