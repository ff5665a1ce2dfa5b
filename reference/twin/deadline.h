// The end of the time that a frame may take.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "reference/twin/abi.h"

namespace shadertwin::twin {

// Sets stop() when `seconds` have passed; never, for 0.
class Deadline {
 public:
  explicit Deadline(double seconds) {
    if (seconds <= 0) return;
    watch_ = std::jthread([this, seconds](const std::stop_token& finished) {
      std::unique_lock lock(mutex_);
      finished_.wait_for(lock, finished, std::chrono::duration<double>(seconds), [] { return false; });
      if (!finished.stop_requested()) __atomic_store_n(&stop_, true, __ATOMIC_RELAXED);
    });
  }

  const bool& stop() const { return stop_; }  // for is_set()
  bool passed() const { return is_set(stop_); }

 private:
  bool stop_ = false;
  std::mutex mutex_;
  std::condition_variable_any finished_;
  std::jthread watch_;  // last, so that it ends first
};

}  // namespace shadertwin::twin
