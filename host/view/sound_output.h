// What is heard while a project plays in the window: its Sound pass, its music and its videos, along with the
// picture's clock.
#pragma once

#include <condition_variable>
#include <functional>
#include <glm/glm.hpp>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/project/project.h"
#include "host/view/player_thread.h"

namespace shadertwin::view {

class SoundOutput {
 public:
  // `make_player` makes what draws the Sound pass. `warn` gets a line that the user should read, in a thread
  // of the sound's own.
  SoundOutput(MakePlayer make_player, std::function<void(const std::string&)> warn);
  ~SoundOutput();
  SoundOutput(const SoundOutput&) = delete;
  SoundOutput& operator=(const SoundOutput&) = delete;

  // From now on this project is heard, as far as it has sound; the device is opened for the first that has.
  // What sounds as before plays on. `date`: iDate of the Sound pass.
  void play(const Project& project, const glm::vec4& date);
  // The picture showed `time` (iTime, seconds) when a steady clock said `now` (seconds), and goes on at the
  // clock's pace; or, `by_frames`, at that of its frames, and then the sound is as much faster or slower.
  void follow(double time, double now, bool by_frames);
  // The picture stands still: silence, until it is followed again.
  void rest();
  // Silence, whatever the picture does.
  void mute(bool muted);
  bool muted() const { return muted_; }
  // Why nothing is heard of the project, once. Window::wake() ends the wait for it.
  std::optional<std::string> take_problem();

 private:
  class Source;
  class Voice;

  // Where the picture is.
  struct Tempo {
    double time = 0.0;
    double now = 0.0;
    double speed = 1.0;  // seconds of the picture in one second
    bool running = false;
  };
  struct Wanted {
    Project project;
    glm::vec4 date;
  };

  void work();

  MakePlayer make_player_;
  std::function<void(const std::string&)> warn_;
  bool muted_ = false;
  std::string sounding_;    // what play() was called for last
  double mark_time_ = 0.0;  // from where the pace of frames is measured
  double mark_now_ = -1.0;

  std::mutex mutex_;  // of what follows
  std::condition_variable wake_;
  bool stop_ = false;
  std::optional<Wanted> wanted_;
  Tempo tempo_;
  std::optional<std::string> problem_;

  std::thread thread_;  // from the first project with sound on
};

}  // namespace shadertwin::view
