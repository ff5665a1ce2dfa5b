// Frames for a person who watches: time runs with the clock, stops when they pause, and goes on by one frame
// when they step.
#pragma once

#include <optional>

#include "host/player/fixed_clock.h"
#include "host/player/fly_camera.h"
#include "host/player/frame.h"
#include "host/player/keyboard.h"
#include "host/player/mouse.h"

namespace shadertwin {

// What the world's clocks say.
struct ClockReading {
  double seconds = 0.0;  // of a steady clock
  Date date;             // local

  static ClockReading now();
};

struct LiveSettings {
  double t0 = 0.0;  // iTime of the first frame, seconds
  // With a rate time goes by frames instead of by the clock: frame i has iTime = t0 + i / rate, as
  // FixedClock.
  std::optional<double> rate = {};
  std::optional<Date> date = {};  // at t0; not given: the wall clock's
  bool paused = false;            // after the first frame
};

class LiveClock {
 public:
  LiveClock(LiveSettings settings, const HostRules& rules);

  // What a hand does goes in here, between frames.
  Mouse& mouse() { return mouse_; }
  KeyboardState& keyboard() { return keyboard_; }
  // 0: left, 1: right; others are nothing to a shader.
  void set_button(int button, bool down) {
    if (button == 0 || button == 1) buttons_[button] = down;
  }

  bool paused() const { return settings_.paused; }
  // Time does not advance while paused, and not by the pause afterwards.
  void set_paused(bool paused);
  // Asks for one more frame at the same time although the clock is paused, as shadertoy.com draws one for
  // every input.
  void force() { forced_ = true; }
  // Pauses, and asks for one more frame, later by 1 / rate (1/60 without one).
  void step();
  // Goes back to frame 0 at t0, and with the camera to where it started. Key toggles and the mouse stay.
  void reset();
  // What a changed shader or size means: time goes on, and so do the frames unless
  // HostRules::recounts_frames.
  void restart_frames();
  // While set, time goes by frames of 1 / rate, for a smooth recording.
  void set_recording(std::optional<double> rate);
  // Another project, perhaps with other rules, from its frame 0.
  void restart(const HostRules& rules);

  // Whether a frame is to be drawn now.
  bool due() const { return !settings_.paused || forced_ || stepped_ || first_; }
  // The values of the next frame.
  Frame next(const ClockReading& now, glm::ivec2 size);

  // Whether time goes by frames, not by the clock.
  bool by_frames() const { return settings_.rate.has_value() || recording_.has_value(); }

  // Of the last frame.
  double time() const { return time_; }
  int index() const { return index_; }
  double frame_rate() const { return frame_rate_; }

 private:
  void measure_rate(double now);

  LiveSettings settings_;
  HostRules rules_;
  Mouse mouse_;
  KeyboardState keyboard_;
  FlyCamera camera_;
  glm::bvec2 buttons_{false};
  std::optional<double> recording_;
  bool first_ = true;     // nothing was drawn since the start or a reset
  bool resumed_ = false;  // nothing was drawn since a pause
  bool forced_ = false;
  bool stepped_ = false;
  double time_ = 0.0;
  int index_ = -1;
  int fixed_index_ = -1;       // frames since the reset, for a fixed rate
  double last_seconds_ = 0.0;  // of the last frame
  double frame_rate_ = 60.0;
  double window_start_ = 0.0;
  int window_frames_ = 0;
};

}  // namespace shadertwin
