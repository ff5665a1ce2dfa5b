// How many samples a picture has that accumulates them, and how long they took.
#pragma once

#include <chrono>
#include <optional>

namespace shadertwin::view {

class SampleCount {
 public:
  // The next sample is the first one.
  void restart() { start_.reset(); }
  void add(bool is_first) {
    if (is_first || !start_.has_value()) {
      start_ = Clock::now();
      count_ = 0;
    }
    ++count_;
  }
  std::optional<int> count() const { return start_.has_value() ? std::optional(count_) : std::nullopt; }
  double seconds() const {
    return start_.has_value() ? std::chrono::duration<double>(Clock::now() - *start_).count() : 0.0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  int count_ = 0;
  std::optional<Clock::time_point> start_;
};

}  // namespace shadertwin::view
