// The sound of a video.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/media/muxer.h"

namespace shadertwin::media {

// Stereo into a stream of the muxer. The stream lasts exactly as long as the samples.
class SoundEncoder {
 public:
  SoundEncoder(Muxer& muxer, const AVCodec& codec, int sample_rate);

  // Left, right, left ...
  void add(std::span<const float> samples);
  void finish();

 private:
  void convert(const float* samples, int count);
  void encode(bool last);

  Muxer& muxer_;
  int sample_rate_;
  Encoder encoder_;
  Resampler resampler_;
  std::vector<float> waiting_;  // at the encoder's rate
  std::int64_t added_ = 0;      // at sample_rate
  std::int64_t converted_ = 0;  // at the encoder's rate
  std::int64_t encoded_ = 0;
};

}  // namespace shadertwin::media
