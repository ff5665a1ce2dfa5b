#include "host/player/fixed_clock.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "host/base/error.h"

namespace shadertwin {

namespace {

constexpr double seconds_per_day = 86400.0;

}  // namespace

Date later(const Date& start, double elapsed) {
  using namespace std::chrono;
  const double total = start.seconds + elapsed;
  const double days_passed = std::floor(total / seconds_per_day);
  const year_month_day date = sys_days(year(start.year) / month(static_cast<unsigned>(start.month)) /
                                       day(static_cast<unsigned>(start.day))) +
                              days(static_cast<int>(days_passed));
  return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day())), total - days_passed * seconds_per_day};
}

glm::vec4 shader_date(const Date& start, double elapsed) {
  const Date date = later(start, elapsed);
  return {static_cast<float>(date.year), static_cast<float>(date.month) - 1.0F, static_cast<float>(date.day),
          static_cast<float>(date.seconds)};
}

std::string Date::text() const {
  const int minutes = static_cast<int>(seconds / 60.0);
  const double rest = seconds - 60.0 * minutes;
  std::array<char, 32> start{};
  std::snprintf(start.data(), start.size(), "%04d-%02d-%02dT%02d:%02d:%s", year, month, day, minutes / 60,
                minutes % 60, rest < 10.0 ? "0" : "");
  std::array<char, 64> digits{};
  const auto [end, failure] =
      std::to_chars(digits.data(), digits.data() + digits.size(), rest, std::chars_format::fixed);
  return start.data() + std::string(digits.data(), end);
}

Date Date::parse(const std::string& text) {
  Date date;
  int hours = 0;
  int minutes = 0;
  double seconds = 0.0;
  int used = 0;
  const int size = static_cast<int>(text.size());
  const char* s = text.c_str();
  bool valid = std::sscanf(s, "%4d-%2d-%2d%n", &date.year, &date.month, &date.day, &used) == 3;
  if (valid && used != size) {
    int time_used = 0;
    valid = std::sscanf(s + used, "T%2d:%2d%n", &hours, &minutes, &time_used) == 2;
    used += time_used;
    if (valid && used != size) {
      valid = std::sscanf(s + used, ":%lf%n", &seconds, &time_used) == 1;
      used += time_used;
    }
  }
  const std::chrono::year_month_day day(std::chrono::year(date.year),
                                        std::chrono::month(static_cast<unsigned>(date.month)),
                                        std::chrono::day(static_cast<unsigned>(date.day)));
  valid = valid && used == size && day.ok() && hours >= 0 && hours < 24 && minutes >= 0 && minutes < 60 &&
          seconds >= 0.0 && seconds < 60.0;
  if (!valid) throw Error(ExitStatus::usage, "expected YYYY-MM-DD or YYYY-MM-DDTHH:MM:SS");
  date.seconds = 3600.0 * hours + 60.0 * minutes + seconds;
  return date;
}

// A key that is let go and pressed again in the same frame is pressed in the end.
void FixedClock::move_keys() {
  for (const KeyStep& step : schedule_.keys)
    if (step.release == index_ && step.frame < index_) keyboard_.release(step.code);
  for (const KeyStep& step : schedule_.keys) {
    if (step.frame != index_) continue;
    keyboard_.press(step.code);
    if (step.release == index_) keyboard_.release(step.code);
  }
}

Frame FixedClock::next() {
  const glm::ivec2 size(schedule_.width, schedule_.height);
  for (const MouseStep& step : schedule_.mouse) {
    if (step.frame != index_) continue;
    // A step with the button up is a click that was let go at once: the position shows, with negative z and
    // w.
    if (!mouse_.down()) {
      mouse_.press(step.position, size);
      if (!step.down) mouse_.next_frame();
    } else {
      mouse_.move(step.position, size);
    }
    if (!step.down) mouse_.release();
  }
  move_keys();

  Frame frame;
  frame.width = schedule_.width;
  frame.height = schedule_.height;
  frame.index = index_;
  const double elapsed = index_ / schedule_.fps;
  frame.time = schedule_.t0 + elapsed;
  frame.time_delta = index_ == 0 ? first_time_delta_ : 1.0 / schedule_.fps;
  frame.frame_rate = schedule_.fps;
  frame.date = shader_date(schedule_.date, elapsed);
  frame.mouse = mouse_.next_frame();
  frame.mouse_button.x = mouse_.down() ? 1.0F : 0.0F;
  camera_.step(keyboard_, mouse_.look());
  frame.view = camera_.matrix();
  frame.keyboard = keyboard_.rows();
  keyboard_.end_frame();
  ++index_;
  return frame;
}

}  // namespace shadertwin
