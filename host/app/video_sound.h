// What is heard while the frames of a video are shown.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/player/fixed_clock.h"
#include "host/player/recordings.h"
#include "host/player/sound.h"

namespace shadertwin::app {

// The Sound pass and what is heard of files, as loud as they are, in one.
class VideoSound {
 public:
  // `player` plays the project and must outlive this. Throws Error(file).
  VideoSound(const Project& project, const Schedule& schedule, Player& player);

  // The samples of the next frame, left and right in turn, in [-1, 1], sound_rate of them a second: those of
  // frames 0 to i are the (i + 1) / fps seconds from the schedule's beginning, rounded to whole samples.
  const std::vector<float>& next_frame();
  // Of the Sound pass; null if there is none.
  const Sound* pass() const { return pass_ ? &*pass_ : nullptr; }

 private:
  double samples_per_frame_;
  std::int64_t first_;  // number of the schedule's first sample
  std::int64_t done_ = 0;
  std::int64_t frames_ = 0;
  std::optional<Sound> pass_;
  Recordings recordings_;
  std::vector<float> mix_;
};

}  // namespace shadertwin::app
