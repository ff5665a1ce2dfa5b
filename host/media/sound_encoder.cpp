#include "host/media/sound_encoder.h"

extern "C" {
#include <libavutil/channel_layout.h>
#include <libavutil/mathematics.h>
}

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

#include "host/base/assert.h"

namespace shadertwin::media {

namespace {

constexpr std::int64_t bits_per_second = 192'000;

AVChannelLayout stereo() {
  AVChannelLayout layout{};
  av_channel_layout_default(&layout, 2);
  return layout;
}

// The codec's own rate that is nearest from above, else its highest.
int rate_for(const AVCodec& codec, int wanted) {
  if (codec.supported_samplerates == nullptr) return wanted;
  int best = 0;
  for (const int* rate = codec.supported_samplerates; *rate != 0; ++rate) {
    const bool enough = *rate >= wanted;
    const bool best_enough = best >= wanted;
    if (best == 0 || (enough && (!best_enough || *rate < best)) || (!enough && !best_enough && *rate > best))
      best = *rate;
  }
  return best;
}

}  // namespace

SoundEncoder::SoundEncoder(Muxer& muxer, const AVCodec& codec, int sample_rate)
    : muxer_(muxer), sample_rate_(sample_rate), encoder_(muxer, codec, [&](AVCodecContext& context) {
        context.sample_rate = rate_for(codec, sample_rate);
        context.time_base = {1, context.sample_rate};
        context.ch_layout = stereo();
        context.sample_fmt = codec.sample_fmts[0];
        for (const AVSampleFormat* format = codec.sample_fmts; *format != AV_SAMPLE_FMT_NONE; ++format)
          if (*format == AV_SAMPLE_FMT_FLT || *format == AV_SAMPLE_FMT_FLTP) context.sample_fmt = *format;
        context.bit_rate = bits_per_second;
      }) {
  AVChannelLayout layout = stereo();
  SwrContext* resampler = nullptr;
  int code = swr_alloc_set_opts2(&resampler, &layout, AV_SAMPLE_FMT_FLT, encoder_.context().sample_rate,
                                 &layout, AV_SAMPLE_FMT_FLT, sample_rate, 0, nullptr);
  resampler_.reset(resampler);
  if (code >= 0) code = swr_init(resampler);
  if (code < 0) muxer_.fail("the sound can't be converted", code);
}

void SoundEncoder::convert(const float* samples, int count) {
  const int room = swr_get_out_samples(resampler_.get(), count);
  const std::size_t before = waiting_.size();
  waiting_.resize(before + std::size_t{2} * static_cast<std::size_t>(std::max(room, 0)));
  auto* out = reinterpret_cast<std::uint8_t*>(waiting_.data() + before);
  const auto* in = reinterpret_cast<const std::uint8_t*>(samples);
  const int made = swr_convert(resampler_.get(), &out, room, samples == nullptr ? nullptr : &in, count);
  if (made < 0) muxer_.fail("the sound can't be converted", made);
  waiting_.resize(before + std::size_t{2} * static_cast<std::size_t>(made));
  converted_ += made;
}

void SoundEncoder::add(std::span<const float> samples) {
  SHADERTWIN_ASSERT_EQ(samples.size() % 2, 0U);
  constexpr std::size_t block = 2 * 4096;
  for (std::size_t at = 0; at < samples.size(); at += block) {
    const std::size_t size = std::min(block, samples.size() - at);
    convert(samples.data() + at, static_cast<int>(size / 2));
  }
  added_ += static_cast<std::int64_t>(samples.size() / 2);
  encode(false);
}

void SoundEncoder::finish() {
  convert(nullptr, 0);
  // The resampler's last sample may be one before or behind the end of the sound.
  const std::int64_t wanted = av_rescale(added_, encoder_.context().sample_rate, sample_rate_);
  const std::int64_t waiting = static_cast<std::int64_t>(waiting_.size() / 2) + wanted - converted_;
  waiting_.resize(static_cast<std::size_t>(2 * std::max<std::int64_t>(waiting, 0)));
  encode(true);
  encoder_.encode(nullptr);
}

void SoundEncoder::encode(bool last) {
  const AVCodecContext& codec = encoder_.context();
  const std::size_t whole = codec.frame_size > 0 ? static_cast<std::size_t>(codec.frame_size) : 1024;
  std::size_t at = 0;
  const std::size_t total = waiting_.size() / 2;
  while (at + whole <= total || (last && at < total)) {
    const std::size_t count = std::min(whole, total - at);
    FramePointer frame = make_frame();
    frame->nb_samples = static_cast<int>(count);
    frame->format = codec.sample_fmt;
    frame->sample_rate = codec.sample_rate;
    frame->ch_layout = codec.ch_layout;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
    const float* const from = waiting_.data() + 2 * at;
    if (codec.sample_fmt == AV_SAMPLE_FMT_FLT) {
      std::memcpy(frame->data[0], from, 2 * count * sizeof(float));
    } else {
      for (std::size_t channel = 0; channel < 2; ++channel) {
        auto* const plane = reinterpret_cast<float*>(frame->data[channel]);
        for (std::size_t i = 0; i < count; ++i) plane[i] = from[2 * i + channel];
      }
    }
    frame->pts = encoded_;
    encoded_ += static_cast<std::int64_t>(count);
    encoder_.encode(frame.get());
    at += count;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(2 * at));
}

}  // namespace shadertwin::media
