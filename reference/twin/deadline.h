// The end of the time that a frame may take.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace shadertwin::twin {

// Sets stop() when `seconds` have passed; never, for 0.
class Deadline {
 public:
  explicit Deadline(double seconds) {
    if (seconds <= 0) return;
    watch_ = std::jthread([this, seconds](const std::stop_token& finished) {
      std::unique_lock lock(mutex_);
      finished_.wait_for(lock, finished, std::chrono::duration<double>(seconds), [] { return false; });
      if (!finished.stop_requested()) stop_ = true;
    });
  }

  const std::atomic<bool>& stop() const { return stop_; }
  bool passed() const { return stop_; }

 private:
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable_any finished_;
  std::jthread watch_;  // last, so that it ends first
};

}  // namespace shadertwin::twin
