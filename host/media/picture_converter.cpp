#include "host/media/picture_converter.h"

#include <new>

#include "host/base/assert.h"

namespace shadertwin::media {

FramePointer make_picture_frame(AVPixelFormat format, int width, int height) {
  FramePointer frame = make_frame();
  frame->format = format;
  frame->width = width;
  frame->height = height;
  if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
  return frame;
}

void fill_rgb(const Image& picture, AVFrame& frame) {
  SHADERTWIN_ASSERT_EQ(picture.width, frame.width);
  SHADERTWIN_ASSERT_EQ(picture.height, frame.height);
  for (int y = 0; y < picture.height; ++y) {
    const float* from = picture.at(0, picture.height - 1 - y);
    std::uint8_t* to = frame.data[0] + static_cast<std::ptrdiff_t>(frame.linesize[0]) * y;
    for (int x = 0; x < picture.width; ++x, from += 4, to += 4) {
      for (int channel = 0; channel < 3; ++channel) to[channel] = canvas_byte(from[channel]);
      to[3] = 255;
    }
  }
}

PictureConverter::PictureConverter(const AVCodecContext& codec)
    : rgb_(make_picture_frame(AV_PIX_FMT_RGB0, codec.width, codec.height)),
      yuv_(make_picture_frame(codec.pix_fmt, codec.width, codec.height)) {
  constexpr int exact = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP;
  scaler_.reset(sws_getContext(codec.width, codec.height, AV_PIX_FMT_RGB0, codec.width, codec.height,
                               codec.pix_fmt, exact, nullptr, nullptr, nullptr));
  if (!scaler_) throw std::bad_alloc();
  const int* const matrix = sws_getCoefficients(SWS_CS_ITU709);
  constexpr int full = 1;
  constexpr int limited = 0;
  constexpr int one = 1 << 16;
  sws_setColorspaceDetails(scaler_.get(), matrix, full, matrix, limited, 0, one, one);
  yuv_->color_range = codec.color_range;
  yuv_->colorspace = codec.colorspace;
  yuv_->color_primaries = codec.color_primaries;
  yuv_->color_trc = codec.color_trc;
  yuv_->chroma_location = codec.chroma_sample_location;
}

const AVFrame& PictureConverter::convert(const Image& picture) {
  fill_rgb(picture, *rgb_);
  // The encoder may still hold the last one.
  if (av_frame_make_writable(yuv_.get()) < 0) throw std::bad_alloc();
  sws_scale(scaler_.get(), rgb_->data, rgb_->linesize, 0, rgb_->height, yuv_->data, yuv_->linesize);
  return *yuv_;
}

}  // namespace shadertwin::media
