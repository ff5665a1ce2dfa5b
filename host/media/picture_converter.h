// Pictures as a video encoder takes them.
#pragma once

#include "host/image/image.h"
#include "host/media/libav.h"

namespace shadertwin::media {

// Copies a picture's canvas bytes, top row first, into a frame of AV_PIX_FMT_RGB0.
void fill_rgb(const Image& picture, AVFrame& frame);

// A frame with buffers of its own. Throws std::bad_alloc.
FramePointer make_picture_frame(AVPixelFormat format, int width, int height);

// RGB to the encoder's YUV, with the matrix and range that it is tagged with.
class PictureConverter {
 public:
  explicit PictureConverter(const AVCodecContext& codec);
  // Valid until the next call. Throws std::bad_alloc.
  const AVFrame& convert(const Image& picture);

 private:
  FramePointer rgb_;
  FramePointer yuv_;
  Scaler scaler_;
};

}  // namespace shadertwin::media
