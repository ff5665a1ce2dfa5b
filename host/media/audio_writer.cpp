#include "host/media/audio_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string>
#include <vector>

#include "host/base/output_file.h"
#include "host/media/muxer.h"

namespace shadertwin::media {

namespace fs = std::filesystem;

namespace {

struct AudioFormat : OutputFormat {
  AVCodecID codec;
  AVSampleFormat samples;
};

constexpr std::array<AudioFormat, 2> formats = {{
    {{".wav", "stereo, float32, 44.1 kHz"}, AV_CODEC_ID_PCM_F32LE, AV_SAMPLE_FMT_FLT},
    {{".flac", "24 bits"}, AV_CODEC_ID_FLAC, AV_SAMPLE_FMT_S32},
}};

// 24 bits, at the upper end of 32.
std::int32_t whole(float value) {
  constexpr double scale = 1 << 23;
  return static_cast<std::int32_t>(std::clamp(std::round(value * scale), -scale, scale - 1.0)) * 256;
}

}  // namespace

struct AudioWriter::State {
  State(const fs::path& file, const AudioFormat& kind, int rate)
      : output(file), format(kind), muxer(output.path(), file.generic_string()), encoder(open_encoder(rate)) {
    muxer.begin();
    frame_size = encoder.context().frame_size > 0 ? encoder.context().frame_size : 4096;
  }

  Encoder open_encoder(int rate) {
    const AVCodec* codec = avcodec_find_encoder(format.codec);
    if (codec == nullptr)
      throw Error(ExitStatus::device,
                  "libav was built without an encoder for " + std::string(format.extension));
    return Encoder(muxer, *codec, [&](AVCodecContext& context) {
      context.sample_fmt = format.samples;
      context.sample_rate = rate;
      av_channel_layout_default(&context.ch_layout, 2);
      context.bits_per_raw_sample = format.samples == AV_SAMPLE_FMT_S32 ? 24 : 32;
      context.time_base = {1, rate};
    });
  }

  // One frame of the encoder's; only the last may be shorter.
  void encode(const float* stereo, int count) {
    const AVCodecContext& codec = encoder.context();
    const FramePointer frame = make_frame();
    frame->format = format.samples;
    frame->sample_rate = codec.sample_rate;
    frame->ch_layout = codec.ch_layout;
    frame->nb_samples = count;
    frame->pts = samples;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
    samples += count;
    const float* end = stereo + std::ptrdiff_t{2} * count;
    if (format.samples == AV_SAMPLE_FMT_FLT)
      std::copy(stereo, end, reinterpret_cast<float*>(frame->data[0]));
    else
      std::transform(stereo, end, reinterpret_cast<std::int32_t*>(frame->data[0]), whole);
    encoder.encode(frame.get());
  }

  OutputFile output;
  const AudioFormat& format;
  Muxer muxer;
  Encoder encoder;
  std::vector<float> waiting;  // less than a frame
  int frame_size = 0;
  std::int64_t samples = 0;
};

std::vector<OutputFormat> audio_formats() {
  return output_formats(formats);
}

bool can_write_audio(const fs::path& file) {
  return find_format(formats, file) != nullptr;
}

AudioWriter::AudioWriter(const fs::path& file, int rate) {
  const AudioFormat* format = find_format(formats, file);
  if (format == nullptr)
    throw Error(ExitStatus::usage, file.generic_string() + ": sound goes into " + list_of(audio_formats()));
  state_ = std::make_unique<State>(file, *format, rate);
}

AudioWriter::~AudioWriter() = default;

void AudioWriter::write(std::span<const float> stereo) {
  std::vector<float>& waiting = state_->waiting;
  waiting.insert(waiting.end(), stereo.begin(), stereo.end());
  const auto frame = static_cast<std::size_t>(state_->frame_size) * 2;
  std::size_t done = 0;
  for (; waiting.size() - done >= frame; done += frame)
    state_->encode(waiting.data() + done, state_->frame_size);
  waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(done));
}

void AudioWriter::finish() {
  State& state = *state_;
  if (!state.waiting.empty()) state.encode(state.waiting.data(), static_cast<int>(state.waiting.size() / 2));
  state.encoder.encode(nullptr);
  state.muxer.end();
  state.output.commit();
}

}  // namespace shadertwin::media
