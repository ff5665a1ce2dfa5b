// What is laid over the picture: which panels are open, what they say, and what was done in them.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "host/player/live_clock.h"
#include "host/view/keys.h"
#include "host/view/overlay.h"
#include "host/view/panels.h"
#include "host/view/playing.h"
#include "host/view/presenter.h"

namespace shadertwin::view {

// What the panels tell of.
struct Scene {
  Playing& playing;
  Presenter& presenter;
  const LiveClock& clock;
  glm::ivec2 size;    // of the last frame, pixels
  const char* scale;  // behind it
  std::optional<int> samples;
  double sample_seconds;
  int recorded;       // frames, -1 while none are
  glm::dvec2 cursor;  // 0 to 1 across the window, y up
};

class Dashboard {
 public:
  using Clock = std::chrono::steady_clock;

  // `quiet`: what a panel says is not printed, too, unless it is an error.
  Dashboard(Window& window, bool quiet) : window_(window), overlay_(window), quiet_(quiet) {}

  // Opens or closes the panel of a key. False if it is of no panel.
  bool toggle(Action action);
  bool inspects() const { return inspector_; }
  bool paints() const { return paint_; }
  // Whether a click at a place in window units, or a key, is for a panel.
  bool wants_mouse(const Playing& playing, glm::dvec2 position) const;
  bool wants_keys(const Playing& playing) const;

  // A line that comes and goes.
  void notice(const std::string& text);
  // When the line goes; none if there is none.
  std::optional<Clock::time_point> notice_until() const;
  // Drops the line if it is time. Whether it did.
  bool expire();
  // An error, until it is cleared.
  void lay_over(const std::string& problem);
  void clear_problem() { problem_.clear(); }

  // Draws what is open. Whether the values of the uniforms were changed.
  bool draw(const Scene& scene);

 private:
  bool shows_any(const Playing& playing) const;
  bool edit_uniforms(Playing& playing);

  Window& window_;
  Overlay overlay_;
  bool quiet_;
  bool help_ = false;
  bool hud_ = true;
  bool inspector_ = false;
  bool sliders_ = true;
  bool paint_ = false;
  std::string problem_;
  std::string notice_;
  Clock::time_point notice_until_;
};

}  // namespace shadertwin::view
