#include "host/media/video_picture.h"

extern "C" {
#include <libavutil/display.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace shadertwin::media {

namespace {

constexpr int largest_side = 16384;

bool is_full_range(const AVFrame& frame) {
  switch (frame.format) {
    case AV_PIX_FMT_YUVJ420P:
    case AV_PIX_FMT_YUVJ422P:
    case AV_PIX_FMT_YUVJ444P:
    case AV_PIX_FMT_YUVJ440P:
    case AV_PIX_FMT_YUVJ411P:
      return true;
    default:
      return frame.color_range == AVCOL_RANGE_JPEG;
  }
}

int matrix_of(const AVFrame& frame) {
  switch (frame.colorspace) {
    case AVCOL_SPC_BT709:
      return SWS_CS_ITU709;
    case AVCOL_SPC_FCC:
      return SWS_CS_FCC;
    case AVCOL_SPC_SMPTE170M:
    case AVCOL_SPC_BT470BG:
      return SWS_CS_ITU601;
    case AVCOL_SPC_SMPTE240M:
      return SWS_CS_SMPTE240M;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
      return SWS_CS_BT2020;
    default:
      return frame.height < 720 ? SWS_CS_ITU601 : SWS_CS_ITU709;
  }
}

int quarter_turns_of(const AVStream& stream) {
  std::size_t size = 0;
  const std::uint8_t* const data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
  if (data == nullptr || size < 9 * sizeof(std::int32_t)) return 0;
  std::array<std::int32_t, 9> matrix{};
  std::memcpy(matrix.data(), data, sizeof matrix);
  const double anticlockwise = av_display_rotation_get(matrix.data());
  if (!std::isfinite(anticlockwise)) return 0;
  return static_cast<int>(std::lround(-anticlockwise / 90.0) % 4 + 4) % 4;
}

}  // namespace

void VideoConverter::set_stream(AVFormatContext& input, const AVStream& stream,
                                const std::filesystem::path& file) {
  if (picture_.width != 0) return;
  double width = stream.codecpar->width;
  double height = stream.codecpar->height;
  const AVRational pixel = av_guess_sample_aspect_ratio(&input, const_cast<AVStream*>(&stream), nullptr);
  if (pixel.num > 0 && pixel.den > 0) {
    const double aspect = av_q2d(pixel);
    (aspect > 1.0 ? width : height) *= aspect > 1.0 ? aspect : 1.0 / aspect;
  }
  if (!(width >= 1.0 && height >= 1.0 && width <= largest_side && height <= largest_side))
    fail(file, "a picture of " + std::to_string(stream.codecpar->width) + "x" +
                   std::to_string(stream.codecpar->height) + " pixels can't be shown");
  width_ = static_cast<int>(std::lround(width));
  height_ = static_cast<int>(std::lround(height));
  quarter_turns_ = quarter_turns_of(stream);
  picture_.format = Texture::Format::rgba8;
  picture_.width = quarter_turns_ % 2 == 0 ? width_ : height_;
  picture_.height = quarter_turns_ % 2 == 0 ? height_ : width_;
  picture_.data.assign(std::size_t{4} * picture_.width * picture_.height, std::byte{0});
}

void VideoConverter::convert(const AVFrame& frame) {
  constexpr int exact = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_BITEXACT;
  scaler_.reset(sws_getCachedContext(scaler_.release(), frame.width, frame.height,
                                     static_cast<AVPixelFormat>(frame.format), width_, height_,
                                     AV_PIX_FMT_RGBA, exact, nullptr, nullptr, nullptr));
  if (!scaler_) return;
  constexpr int one = 1 << 16;
  sws_setColorspaceDetails(scaler_.get(), sws_getCoefficients(matrix_of(frame)), is_full_range(frame) ? 1 : 0,
                           sws_getCoefficients(SWS_CS_ITU709), 1, 0, one, one);
  std::vector<std::byte>& target = quarter_turns_ == 0 ? picture_.data : unturned_;
  target.resize(std::size_t{4} * width_ * height_);
  const bool flipped = quarter_turns_ == 0 && flip_;
  const int row = 4 * width_;
  auto* const first = reinterpret_cast<std::uint8_t*>(target.data());
  std::uint8_t* const planes[4] = {flipped ? first + static_cast<std::ptrdiff_t>(row) * (height_ - 1)
                                           : first};
  const int strides[4] = {flipped ? -row : row};
  sws_scale(scaler_.get(), frame.data, frame.linesize, 0, frame.height, planes, strides);
  if (quarter_turns_ != 0) turn(unturned_);
}

void VideoConverter::turn(const std::vector<std::byte>& upright) {
  for (int y = 0; y < picture_.height; ++y)
    for (int x = 0; x < picture_.width; ++x) {
      // Where the texel at column x, row y from the top was before the turn.
      const std::array<int, 2> from = quarter_turns_ == 1   ? std::array{y, height_ - 1 - x}
                                      : quarter_turns_ == 2 ? std::array{width_ - 1 - x, height_ - 1 - y}
                                                            : std::array{width_ - 1 - y, x};
      const int row = flip_ ? picture_.height - 1 - y : y;
      std::memcpy(&picture_.data[std::size_t{4} * (static_cast<std::size_t>(row) * picture_.width + x)],
                  &upright[std::size_t{4} * (static_cast<std::size_t>(from[1]) * width_ + from[0])], 4);
    }
}

}  // namespace shadertwin::media
