// Frames at a fixed step: frame i has iTime = t0 + i / fps whatever the clock says, so that the same command
// gives the same frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/player/fly_camera.h"
#include "host/player/frame.h"
#include "host/player/keyboard.h"
#include "host/player/mouse.h"
#include "host/project/project.h"

namespace shadertwin {

struct MouseStep {
  int frame = 0;  // from which on
  glm::dvec2 position{0.0};
  bool down = false;
};

struct KeyStep {
  int frame = 0;  // from which on the key is held
  int code = 0;
  std::optional<int> release =
      {};  // the frame that first sees it released; `frame` itself: a tap between two frames
};

// Local time without a zone.
struct Date {
  int year = 2024;
  int month = 1;  // 1 to 12
  int day = 1;
  double seconds = 0.0;  // since midnight

  // Reads YYYY-MM-DD, or YYYY-MM-DDTHH:MM[:SS[.fraction]]. Throws Error(usage) that says so.
  static Date parse(const std::string& text);
  // YYYY-MM-DDTHH:MM:SS[.fraction], as parse() reads it.
  std::string text() const;
  bool operator==(const Date&) const = default;
};

// `elapsed` seconds after `start`.
Date later(const Date& start, double elapsed);

// iDate `elapsed` seconds after `start`: the full year, month from 0, day from 1, seconds since midnight with
// their fraction.
glm::vec4 shader_date(const Date& start, double elapsed);

struct Schedule {
  int width = 640;
  int height = 360;
  double fps = 60.0;
  double t0 = 0.0;               // seconds
  Date date;                     // at t0
  std::vector<MouseStep> mouse;  // by frame
  std::vector<KeyStep> keys;
};

class FixedClock {
 public:
  FixedClock(Schedule schedule, const HostRules& rules)
      : schedule_(std::move(schedule)),
        first_time_delta_(rules.idle_time_delta),
        mouse_(rules),
        keyboard_(rules) {}

  // Frame 0, 1, 2 ...
  Frame next();

 private:
  void move_keys();

  Schedule schedule_;
  double first_time_delta_;
  Mouse mouse_;
  KeyboardState keyboard_;
  FlyCamera camera_;
  int index_ = 0;
};

}  // namespace shadertwin
