// What Web Audio's AnalyserNode gives, from the samples that it would have heard.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace shadertwin::media {

// https://www.w3.org/TR/webaudio/#AnalyserNode with the values that a new node has: Blackman window of alpha
// 0.16, smoothing over time by 0.8, decibels from -100 to -30.
class Analyser {
 public:
  // `size`: samples of a window, a power of two.
  explicit Analyser(std::size_t size);
  ~Analyser();

  std::size_t size() const { return window_.size(); }
  // Analyses the last size() samples, oldest first. Each call smooths with those before, as each frame of a
  // page that asks does.
  void hear(std::span<const float> samples);
  // Forgets the calls before.
  void reset();

  // getByteFrequencyData: bins 0 to size() / 2, of which as many as fit. 0: -100 dB and below, 255: -30 dB.
  void spectrum(std::span<std::uint8_t> bytes) const;
  // getByteTimeDomainData: the oldest samples, as many as fit. 128 is silence, 0 is -1, 255 is 1.
  void wave(std::span<std::uint8_t> bytes) const;

 private:
  struct Transform;

  std::vector<double> window_;
  std::vector<float> samples_;
  std::vector<double> magnitudes_;  // smoothed
  std::unique_ptr<Transform> transform_;
};

}  // namespace shadertwin::media
