#include "host/app/video_sound.h"

#include <algorithm>
#include <cmath>

namespace shadertwin::app {

VideoSound::VideoSound(const Project& project, const Schedule& schedule, Player& player)
    : samples_per_frame_(sound_rate / schedule.fps),
      first_(static_cast<std::int64_t>(std::llround(schedule.t0 * sound_rate))),
      recordings_(project) {
  if (find_sound(project) >= 0) pass_.emplace(player, shader_date(schedule.date, 0.0), first_);
}

const std::vector<float>& VideoSound::next_frame() {
  ++frames_;
  const auto end = static_cast<std::int64_t>(std::llround(static_cast<double>(frames_) * samples_per_frame_));
  mix_.assign(static_cast<std::size_t>(2 * (end - done_)), 0.0F);
  if (pass_) pass_->read(mix_);
  recordings_.add(first_ + done_, mix_);
  for (float& sample : mix_) sample = std::clamp(sample, -1.0F, 1.0F);
  done_ = end;
  return mix_;
}

}  // namespace shadertwin::app
