#include "host/player/rounds.h"

#include "host/player/inputs.h"

namespace shadertwin {

Rounds::Rounds(const Project& project) : rules_(host_rules(project)), shown_(project.passes.size(), 0) {
  for (const bool history : passes_with_history(project)) pictures_.push_back(history ? 2 : 1);
}

std::optional<Frame> Rounds::begin(const Frame& frame) {
  const glm::ivec2 size(frame.width, frame.height);
  const bool first = size_.x == 0;
  const bool resized = !first && size != size_;
  size_ = size;
  // The extension counts frames from 0 again after a resize, but neither compiles nor measures its buffers
  // then.
  const bool starts = first || (frame.index == 0 && !resized);
  if (!rules_.reports_first_size || starts) reported_size_ = size;
  rehearsing_ = rules_.warms_up && starts && frame.index == 0;
  if (!rehearsing_) return std::nullopt;
  // Time stands at 0 in it. What else it sees is not known of the extension; here it is what frame 0 sees.
  Frame rehearsal = frame;
  rehearsal.time = rehearsal.time_delta = 0.0;
  return rehearsal;
}

std::size_t Rounds::read_by(std::size_t reader, std::size_t source) const {
  if (!rules_.swaps_after_frame || reader == source) return shown(source);
  // Outside of a rehearsal an earlier pass has just changed its places.
  return source < reader && !rehearsing_ ? shown(source) : target(source);
}

void Rounds::drawn(std::size_t pass) {
  if (!rehearsing_) shown_[pass] = target(pass);
}

}  // namespace shadertwin
