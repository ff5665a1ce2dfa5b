// A progress bar on a terminal; nothing on a pipe.
#pragma once

#include <chrono>
#include <string>

namespace shadertwin::app {

class Progress {
 public:
  // `label` says what is counted. Shows nothing if `quiet`, or if stderr is not a terminal.
  Progress(std::string label, int total, bool quiet);
  // Removes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  bool visible() const { return visible_; }
  // Redraws at most ten times a second.
  void update(int done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  int total_;
  bool visible_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

}  // namespace shadertwin::app
