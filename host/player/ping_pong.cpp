#include "host/player/ping_pong.h"

#include "host/player/inputs.h"

namespace shadertwin {

PingPong::PingPong(const Project& project) : rules_(host_rules(project)), front_(project.passes.size(), 0) {
  for (const bool history : passes_with_history(project)) targets_.push_back(history ? 2 : 1);
}

std::optional<Frame> PingPong::begin(const Frame& frame) {
  const glm::ivec2 size(frame.width, frame.height);
  const bool first = size_.x == 0;
  const bool resized = !first && size != size_;
  size_ = size;
  // The extension counts frames from 0 again after a resize, but neither compiles nor measures its buffers
  // then.
  const bool starts = first || (frame.index == 0 && !resized);
  if (!rules_.reports_first_size || starts) reported_size_ = size;
  warming_up_ = rules_.warms_up && starts && frame.index == 0;
  if (!warming_up_) return std::nullopt;
  // Time stands at 0 in it. What else it sees is not known of the extension; here it is what frame 0 sees.
  Frame warm_up = frame;
  warm_up.time = warm_up.time_delta = 0.0;
  return warm_up;
}

std::size_t PingPong::read_by(std::size_t reader, std::size_t source) const {
  if (!rules_.swaps_after_frame || reader == source) return front(source);
  // Outside of a warm-up an earlier pass has just been swapped.
  return source < reader && !warming_up_ ? front(source) : back(source);
}

void PingPong::drawn(std::size_t pass) {
  if (!warming_up_) front_[pass] = back(pass);
}

}  // namespace shadertwin
