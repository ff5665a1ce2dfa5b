#include "host/media/analyser.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

extern "C" {
#include <libavutil/tx.h>
}

#include "host/base/assert.h"

namespace shadertwin::media {

namespace {

constexpr double smoothing = 0.8;
constexpr double min_decibels = -100.0;
constexpr double max_decibels = -30.0;

}  // namespace

// libav's own FFT: of real values, in double.
struct Analyser::Transform {
  explicit Transform(std::size_t size) : input(size), output(size / 2 + 1) {
    constexpr double scale = 1.0;
    if (av_tx_init(&context, &run, AV_TX_DOUBLE_RDFT, 0, static_cast<int>(size), &scale, AV_TX_UNALIGNED) < 0)
      throw std::bad_alloc();
  }
  ~Transform() { av_tx_uninit(&context); }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  AVTXContext* context = nullptr;
  av_tx_fn run = nullptr;
  std::vector<double> input;
  std::vector<AVComplexDouble> output;
};

Analyser::Analyser(std::size_t size)
    : window_(size), samples_(size), magnitudes_(size / 2), transform_(std::make_unique<Transform>(size)) {
  constexpr double alpha = 0.16;
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
    window_[i] = (1.0 - alpha) / 2.0 - 0.5 * std::cos(angle) + alpha / 2.0 * std::cos(2.0 * angle);
  }
}

Analyser::~Analyser() = default;

void Analyser::hear(std::span<const float> samples) {
  SHADERTWIN_ASSERT_EQ(samples.size(), samples_.size());
  std::copy_n(samples.begin(), samples_.size(), samples_.begin());
  for (std::size_t i = 0; i < window_.size(); ++i) transform_->input[i] = window_[i] * samples_[i];
  transform_->run(transform_->context, transform_->output.data(), transform_->input.data(), sizeof(double));
  const auto size = static_cast<double>(window_.size());
  for (std::size_t i = 0; i < magnitudes_.size(); ++i) {
    const AVComplexDouble& bin = transform_->output[i];
    const double smoothed =
        smoothing * magnitudes_[i] + (1.0 - smoothing) * std::hypot(bin.re, bin.im) / size;
    magnitudes_[i] = std::isfinite(smoothed) ? smoothed : 0.0;
  }
}

void Analyser::reset() {
  std::fill(magnitudes_.begin(), magnitudes_.end(), 0.0);
  std::fill(samples_.begin(), samples_.end(), 0.0F);
}

void Analyser::spectrum(std::span<std::uint8_t> bytes) const {
  for (std::size_t i = 0; i < std::min(bytes.size(), magnitudes_.size()); ++i) {
    const double decibels = 20.0 * std::log10(magnitudes_[i]);
    const double level = 255.0 / (max_decibels - min_decibels) * (decibels - min_decibels);
    bytes[i] = static_cast<std::uint8_t>(std::clamp(std::floor(level), 0.0, 255.0));
  }
}

void Analyser::wave(std::span<std::uint8_t> bytes) const {
  for (std::size_t i = 0; i < std::min(bytes.size(), samples_.size()); ++i)
    bytes[i] = static_cast<std::uint8_t>(std::clamp(std::floor(128.0 * (1.0 + samples_[i])), 0.0, 255.0));
}

}  // namespace shadertwin::media
