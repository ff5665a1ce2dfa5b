#include "host/player/live_clock.h"

#include <chrono>
#include <ctime>

namespace shadertwin {

namespace {

constexpr double usual_delta = 1.0 / 60.0;  // what shadertoy.com says where there is nothing to measure
constexpr double rate_window = 0.5;         // seconds over which it averages iFrameRate

}  // namespace

ClockReading ClockReading::now() {
  using namespace std::chrono;
  const auto wall = system_clock::now();
  const std::time_t whole = system_clock::to_time_t(floor<std::chrono::seconds>(wall));
  std::tm local{};
  localtime_r(&whole, &local);
  const double fraction = duration<double>(wall - floor<std::chrono::seconds>(wall)).count();
  ClockReading reading;
  reading.seconds = duration<double>(steady_clock::now().time_since_epoch()).count();
  reading.date.year = local.tm_year + 1900;
  reading.date.month = local.tm_mon + 1;
  reading.date.day = local.tm_mday;
  reading.date.seconds = 3600.0 * local.tm_hour + 60.0 * local.tm_min + local.tm_sec + fraction;
  return reading;
}

LiveClock::LiveClock(LiveSettings settings, const HostRules& rules)
    : settings_(settings), rules_(rules), mouse_(rules), keyboard_(rules), time_(settings_.t0) {}

void LiveClock::set_paused(bool paused) {
  if (settings_.paused && !paused) resumed_ = true;
  settings_.paused = paused;
}

void LiveClock::step() {
  settings_.paused = true;
  stepped_ = true;
}

void LiveClock::reset() {
  first_ = true;
  forced_ = stepped_ = false;
  camera_ = FlyCamera();
  time_ = settings_.t0;
  index_ = fixed_index_ = -1;
}

void LiveClock::restart_frames() {
  if (rules_.recounts_frames) index_ = -1;
  force();
}

void LiveClock::set_recording(std::optional<double> rate) {
  if (recording_.has_value() && !rate.has_value()) resumed_ = true;
  recording_ = rate;
}

void LiveClock::restart(const HostRules& rules) {
  rules_ = rules;
  mouse_ = Mouse(rules);
  keyboard_ = KeyboardState(rules);
  reset();
}

Frame LiveClock::next(const ClockReading& now, glm::ivec2 size) {
  const std::optional<double> rate = recording_.has_value() ? recording_ : settings_.rate;
  const double step = rate.has_value() ? 1.0 / *rate : usual_delta;
  const bool still = settings_.paused && !stepped_;  // a forced frame
  double delta = first_ || still ? rules_.idle_time_delta : usual_delta;
  if (first_) {
    fixed_index_ = 0;
  } else if (!still) {
    ++fixed_index_;
    delta = stepped_ || rate.has_value() ? step : resumed_ ? usual_delta : now.seconds - last_seconds_;
    if (settings_.rate.has_value() && !recording_.has_value())
      time_ = settings_.t0 + fixed_index_ / *settings_.rate;  // not a sum, whose rounding would grow
    else if (!resumed_ || stepped_)
      time_ += delta;
  }
  ++index_;
  if (rate.has_value())
    frame_rate_ = *rate;
  else
    measure_rate(now.seconds);

  Frame frame;
  frame.width = size.x;
  frame.height = size.y;
  frame.index = index_;
  frame.time = time_;
  frame.time_delta = delta;
  frame.frame_rate = frame_rate_;
  frame.date =
      settings_.date ? shader_date(*settings_.date, time_ - settings_.t0) : shader_date(now.date, 0.0);
  frame.mouse = mouse_.next_frame();
  frame.mouse_button = {buttons_.x ? 1.0F : 0.0F, buttons_.y ? 1.0F : 0.0F, 0.0F, 0.0F};
  if (!still) camera_.step(keyboard_, mouse_.look());
  frame.view = camera_.matrix();
  frame.keyboard = keyboard_.rows();
  keyboard_.end_frame();

  first_ = resumed_ = forced_ = stepped_ = false;
  last_seconds_ = now.seconds;
  return frame;
}

void LiveClock::measure_rate(double now) {
  if (first_ || resumed_ || settings_.paused) {
    window_start_ = now;
    window_frames_ = 0;
    return;
  }
  ++window_frames_;
  if (now - window_start_ <= rate_window) return;
  frame_rate_ = window_frames_ / (now - window_start_);
  window_start_ = now;
  window_frames_ = 0;
}

}  // namespace shadertwin
