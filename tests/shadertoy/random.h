// Random inputs that a test makes up itself, from a fixed seed.
#pragma once

#include <cmath>
#include <cstdint>

namespace shadertwin {

// Uniform floats of 24 bits. SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 0x632be59bd9b4e019ULL) {}
  double uniform() { return static_cast<double>(next() >> 40) * 0x1p-24; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Magnitudes of all scales between low and high, both > 0.
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  double sign() { return (next() >> 63) ? 1.0 : -1.0; }
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

}  // namespace shadertwin
