#include "host/player/audio_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

#include "host/media/analyser.h"
#include "host/media/audio_file.h"
#include "host/media/microphone.h"
#include "host/project/host_rules.h"

namespace shadertwin {

namespace {

constexpr std::size_t columns = 512;

struct Bytes {
  std::array<std::uint8_t, columns> spectrum{};
  std::array<std::uint8_t, columns> wave{};

  bool operator==(const Bytes&) const = default;
};

// What silence looks like.
Bytes silence() {
  Bytes bytes;
  bytes.wave.fill(128);
  return bytes;
}

class AudioTexture : public MovingInput {
 public:
  explicit AudioTexture(const HostRules& rules) : grey_(rules.grey_tables) {
    texture_.width = static_cast<int>(columns);
    texture_.height = 2;
    texture_.data.resize(2 * columns * texture_.texel_bytes(), std::byte{255});
    show(silence());
  }

  bool update(const Frame& frame) final {
    const Bytes bytes = analyse(frame);
    if (bytes == shown_) return false;
    show(bytes);
    return true;
  }
  const Texture& texture() const final { return texture_; }

 protected:
  virtual Bytes analyse(const Frame& frame) = 0;

 private:
  void show(const Bytes& bytes) {
    shown_ = bytes;
    for (std::size_t i = 0; i < 2 * columns; ++i) {
      const auto value = static_cast<std::byte>(i < columns ? bytes.spectrum[i] : bytes.wave[i - columns]);
      texture_.data[4 * i] = value;
      texture_.data[4 * i + 1] = texture_.data[4 * i + 2] = grey_ ? value : std::byte{0};
    }
  }

  bool grey_;
  Bytes shown_;
  Texture texture_;
};

class Silence final : public AudioTexture {
 public:
  using AudioTexture::AudioTexture;
  double time() const override { return 0.0; }

 private:
  Bytes analyse(const Frame&) override { return silence(); }
};

// The signal that shadertoy.com shows where sound is muted: a falling spectrum that flickers, with a beat a
// second in the lowest three bins, and a wave of two sines.
class Preview final : public AudioTexture {
 public:
  using AudioTexture::AudioTexture;
  double time() const override { return 10.0 + time_; }

 private:
  Bytes analyse(const Frame& frame) override {
    time_ = frame.time;
    Bytes bytes;
    const double beat = std::pow(0.5 + 0.5 * std::sin(2.0 * std::numbers::pi * time_), 4.0);
    for (std::size_t i = 0; i < columns; ++i) {
      const auto j = static_cast<double>(i);
      const double x = j / columns;
      const double level = i < 3 ? beat * (1.0 - j / 3.0)
                                 : (0.75 + 0.25 * std::sin(10.0 * j + 13.0 * time_)) * std::exp(-3.0 * x);
      const double wave = 0.5 + 0.15 * std::sin(17.0 * time_ + 20.0 * std::numbers::pi * x) *
                                    std::sin(23.0 * time_ + 1.9 * x);
      bytes.spectrum[i] = static_cast<std::uint8_t>(255.0 * level);
      bytes.wave[i] = static_cast<std::uint8_t>(255.0 * wave);
    }
    return bytes;
  }

  double time_ = 0.0;
};

// The last samples at the time of a frame, analysed as on a page that plays them. A spectrum has
// half as many bins as samples, which may be fewer than columns.
class Listener {
 public:
  explicit Listener(const HostRules& rules) : analyser_(static_cast<std::size_t>(rules.analysed_samples)) {}

  std::size_t size() const { return analyser_.size(); }
  void reset() { analyser_.reset(); }
  Bytes hear(std::span<const float> mono) {
    analyser_.hear(mono);
    Bytes bytes;
    analyser_.wave(bytes.wave);
    std::vector<std::uint8_t> bins(std::min(columns, size() / 2));
    analyser_.spectrum(bins);
    for (std::size_t i = 0; i < columns; ++i) bytes.spectrum[i] = bins[i * bins.size() / columns];
    return bytes;
  }

 private:
  media::Analyser analyser_;
};

class Music final : public AudioTexture {
 public:
  Music(const std::filesystem::path& file, const HostRules& rules)
      : AudioTexture(rules),
        file_(file, sound_rate),
        listener_(rules),
        stereo_(2 * listener_.size()),
        mono_(listener_.size()) {}

  double time() const override { return time_ > 0.0 ? std::fmod(time_, file_.seconds()) : 0.0; }

 private:
  Bytes analyse(const Frame& frame) override {
    if (frame.index == 0) listener_.reset();
    time_ = frame.time;
    const auto heard = static_cast<std::int64_t>(std::llround(time_ * sound_rate));
    file_.read(heard - static_cast<std::int64_t>(mono_.size()), stereo_);
    const float gain = file_.mono_gain();
    for (std::size_t i = 0; i < mono_.size(); ++i) mono_[i] = gain * (stereo_[2 * i] + stereo_[2 * i + 1]);
    return listener_.hear(mono_);
  }

  media::AudioFile file_;
  Listener listener_;
  std::vector<float> stereo_;
  std::vector<float> mono_;
  double time_ = 0.0;
};

class LiveSound final : public AudioTexture {
 public:
  LiveSound(std::unique_ptr<media::Microphone> microphone, const HostRules& rules)
      : AudioTexture(rules), microphone_(std::move(microphone)), listener_(rules), mono_(listener_.size()) {}

  double time() const override { return 0.0; }  // as on shadertoy.com

 private:
  Bytes analyse(const Frame&) override {
    microphone_->listen(mono_);
    return listener_.hear(mono_);
  }

  std::unique_ptr<media::Microphone> microphone_;
  Listener listener_;
  std::vector<float> mono_;
};

}  // namespace

std::unique_ptr<MovingInput> open_audio_input(const Project& project, const Input& input,
                                              std::vector<std::string>& warnings) {
  const HostRules rules = host_rules(project);
  if (project.muted) return std::make_unique<Preview>(rules);
  if (!input.files.empty()) return std::make_unique<Music>(input.files.front(), rules);
  if (input.kind == InputKind::microphone) {
    std::string why;
    if (auto microphone = media::Microphone::open(sound_rate, why))
      return std::make_unique<LiveSound>(std::move(microphone), rules);
    warnings.push_back("warning: there is no microphone (" + why +
                       "): the channel is silent (--mute gives shadertoy.com's preview)");
  }
  return std::make_unique<Silence>(rules);
}

}  // namespace shadertwin
