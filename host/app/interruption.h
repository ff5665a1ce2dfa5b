// Ctrl-C while a file is half written.
#pragma once

#include <array>
#include <csignal>

namespace shadertwin::app {

// From here on the first SIGINT, SIGTERM or SIGHUP is only noted, so that its receiver can clean up; a second
// one ends the program at once. The destructor passes the noted signal on, which ends the program as if
// nothing had held it back. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool requested() const;

 private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace shadertwin::app
