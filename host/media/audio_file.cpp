#include "host/media/audio_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "host/media/libav.h"
#include "host/media/riff.h"

namespace shadertwin::media {

namespace fs = std::filesystem;

namespace {

constexpr double max_seconds = 3600.0;  // 1.3 GB of floats
// Those that Web Audio has to take.
constexpr int max_failures = 100;
constexpr int min_rate = 3000;
constexpr int max_rate = 768000;

constexpr float half_power = std::numbers::sqrt2_v<float> / 2.0F;

int audio_stream(const InputFormat& input, const fs::path& file) {
  const int index = av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
  if (index < 0) fail(file, "there is no sound in it");
  for (unsigned i = 0; i < input->nb_streams; ++i)
    if (static_cast<int>(i) != index) input->streams[i]->discard = AVDISCARD_ALL;
  return index;
}

// Seconds that the stream really has, from all of its packets without decoding them. Fails if it says that it
// has more.
double measure(const fs::path& file) {
  const InputFormat input = open_input(file);
  if (const std::uint64_t missing = missing_riff_bytes(file); missing > 0)
    fail(file, "it breaks off: " + std::to_string(missing) + " bytes of sound are missing");
  const int index = audio_stream(input, file);
  const AVStream& stream = *input->streams[index];
  if (stream.codecpar->sample_rate < min_rate || stream.codecpar->sample_rate > max_rate)
    fail(file, "its sample rate is " + std::to_string(stream.codecpar->sample_rate) + " Hz");
  const PacketPointer packet(av_packet_alloc());
  if (packet == nullptr) throw std::bad_alloc();
  std::int64_t ticks = 0;
  while (av_read_frame(input.get(), packet.get()) >= 0) {
    if (packet->stream_index == index) ticks += std::max<std::int64_t>(packet->duration, 0);
    av_packet_unref(packet.get());
  }
  const double tick = av_q2d(stream.time_base);
  const double there = static_cast<double>(ticks) * tick;
  double claimed = 0.0;
  if (stream.duration != AV_NOPTS_VALUE) claimed = static_cast<double>(stream.duration) * tick;
  // A guess from the size of the file is no claim.
  const bool guessed = input->duration_estimation_method == AVFMT_DURATION_FROM_BITRATE;
  const double tolerance = std::max(0.25, 0.01 * claimed);
  if (!guessed && there > 0.0 && there < claimed - tolerance)
    fail(file,
         "it breaks off after " + std::to_string(there) + " of " + std::to_string(claimed) + " seconds");
  if (std::max(there, guessed ? 0.0 : claimed) > max_seconds) fail(file, "it is longer than an hour");
  return there;
}

}  // namespace

bool has_sound(const fs::path& file) {
  const InputFormat input = open_input(file);
  return av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0) >= 0;
}

struct AudioFile::State {
  State(const fs::path& name, int sample_rate) : file(name), rate(sample_rate) {
    seconds = measure(file);
    input = open_input(file);
    index = audio_stream(input, file);
    decoder = open_decoder(*input->streams[index], file);
    packet.reset(av_packet_alloc());
    frame.reset(av_frame_alloc());
    if (packet == nullptr || frame == nullptr) throw std::bad_alloc();
    decode_until(0);
    if (samples.empty()) fail(file, "there is no sound in it that can be decoded");
  }

  std::int64_t count() const { return static_cast<std::int64_t>(samples.size() / 2); }

  // Decodes until sample `last` is there, or all are.
  void decode_until(std::int64_t last) {
    while (!complete && count() <= last) {
      const int received = avcodec_receive_frame(decoder.get(), frame.get());
      const bool is_usual = received >= 0 || received == AVERROR_EOF || received == AVERROR(EAGAIN);
      failures = is_usual ? 0 : failures + 1;
      if (received == AVERROR_EOF) {
        convert(nullptr);
        finish();
      } else if (received == AVERROR(EAGAIN)) {
        send();
      } else if (received >= 0) {
        convert(frame.get());
        av_frame_unref(frame.get());
        if (static_cast<double>(count()) > max_seconds * rate) finish();
      } else if (failures > max_failures) {
        finish();
      }
      // What can't be decoded is left out, as in a browser.
    }
  }

  void finish() {
    complete = true;
    if (count() > 0) seconds = static_cast<double>(count()) / rate;
    decoder.reset();
    resampler.reset();
    input.reset();
  }

  void send() {
    if (av_read_frame(input.get(), packet.get()) < 0) {
      avcodec_send_packet(decoder.get(), nullptr);
      return;
    }
    if (packet->stream_index == index) avcodec_send_packet(decoder.get(), packet.get());
    av_packet_unref(packet.get());
  }

  // Appends a frame, at the wanted rate, mixed to stereo. Null: what the resampler still holds.
  void convert(const AVFrame* decoded) {
    if (decoded != nullptr) {
      if (decoded->sample_rate < min_rate || decoded->sample_rate > max_rate) return;
      const bool same = resampler != nullptr && decoded->sample_rate == in_rate &&
                        decoded->ch_layout.nb_channels == channels && decoded->format == in_format;
      if (!same) {
        if (resampler != nullptr) convert(nullptr);
        configure(*decoded);
      }
    }
    if (resampler == nullptr) return;
    const int in_count = decoded == nullptr ? 0 : decoded->nb_samples;
    const int room = std::max(check(swr_get_out_samples(resampler.get(), in_count), file), 1);
    planes.resize(static_cast<std::size_t>(channels));
    std::vector<std::uint8_t*> outputs;
    for (std::vector<float>& plane : planes) {
      plane.resize(static_cast<std::size_t>(room));
      outputs.push_back(reinterpret_cast<std::uint8_t*>(plane.data()));
    }
    const auto** in = decoded == nullptr ? nullptr : const_cast<const std::uint8_t**>(decoded->extended_data);
    const int made = check(swr_convert(resampler.get(), outputs.data(), room, in, in_count), file);
    for (std::size_t i = 0; i < static_cast<std::size_t>(made); ++i) mix(i);
  }

  void configure(const AVFrame& decoded) {
    in_rate = decoded.sample_rate;
    in_format = decoded.format;
    channels = decoded.ch_layout.nb_channels;
    AVChannelLayout layout = decoded.ch_layout;
    SwrContext* made = nullptr;
    check(swr_alloc_set_opts2(&made, &layout, AV_SAMPLE_FMT_FLTP, rate, &layout,
                              static_cast<AVSampleFormat>(decoded.format), decoded.sample_rate, 0, nullptr),
          file);
    resampler.reset(made);
    check(swr_init(resampler.get()), file);
  }

  // https://www.w3.org/TR/webaudio/#ChannelLayouts
  void mix(std::size_t i) {
    const auto in = [&](int channel) {
      const float value = planes[static_cast<std::size_t>(channel)][i];
      return std::isfinite(value) ? value : 0.0F;
    };
    switch (channels) {
      case 1:
        samples.insert(samples.end(), {in(0), in(0)});
        break;
      case 4:
        samples.insert(samples.end(), {0.5F * (in(0) + in(2)), 0.5F * (in(1) + in(3))});
        break;
      case 6:
        samples.insert(samples.end(),
                       {in(0) + half_power * (in(2) + in(4)), in(1) + half_power * (in(2) + in(5))});
        break;
      default:
        samples.insert(samples.end(), {in(0), in(1)});
    }
  }

  fs::path file;
  int rate;
  double seconds = 0.0;
  InputFormat input;
  int index = -1;
  CodecContext decoder;
  PacketPointer packet;
  FramePointer frame;
  Resampler resampler;
  int in_rate = 0;
  int in_format = -1;
  int channels = 0;
  std::vector<std::vector<float>> planes;
  std::vector<float> samples;  // as far as decoded
  bool complete = false;
  int failures = 0;  // of the decoder, in a row
};

AudioFile::AudioFile(const fs::path& file, int rate) : state_(std::make_unique<State>(file, rate)) {}

AudioFile::~AudioFile() = default;

void AudioFile::read(std::int64_t first, std::span<float> stereo) {
  State& state = *state_;
  const auto count = static_cast<std::int64_t>(stereo.size() / 2);
  state.decode_until(first + count - 1);
  const std::int64_t round = state.complete ? state.count() : std::numeric_limits<std::int64_t>::max();
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t sample = first + i;
    const auto at = static_cast<std::size_t>(sample < 0 ? 0 : sample % round) * 2;
    const auto to = static_cast<std::size_t>(i) * 2;
    stereo[to] = sample < 0 ? 0.0F : state.samples[at];
    stereo[to + 1] = sample < 0 ? 0.0F : state.samples[at + 1];
  }
}

float AudioFile::mono_gain() const {
  return state_->channels == 6 ? half_power : 0.5F;
}

double AudioFile::seconds() const {
  return state_->seconds;
}

}  // namespace shadertwin::media
