#include "host/app/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace shadertwin::app {

namespace {

constexpr int bar_width = 30;
constexpr auto redraw_interval = std::chrono::milliseconds(100);

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(std::lround(seconds));
  char text[32];
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

}  // namespace

Progress::Progress(std::string label, int total, bool quiet)
    : label_(std::move(label)), total_(total), visible_(!quiet && total > 1 && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::update(int done) {
  const auto now = Clock::now();
  if (!visible_ || now - drawn_ < redraw_interval) return;
  drawn_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double rate = elapsed > 0.0 ? done / elapsed : 0.0;
  const int filled = static_cast<int>(static_cast<long long>(bar_width) * done / total_);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(bar_width - filled), '.');
  const std::string left = rate > 0.0 ? clock_text((total_ - done) / rate) + " left" : std::string("...");
  std::fprintf(stderr, "\r\033[K%s [%s] %d/%d  %.1f/s  %s", label_.c_str(), bar.c_str(), done, total_, rate,
               left.c_str());
  std::fflush(stderr);
}

}  // namespace shadertwin::app
