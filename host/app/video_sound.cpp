#include "host/app/video_sound.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "host/player/inputs.h"

namespace shadertwin::app {

namespace {

std::set<std::filesystem::path> music_files(const Project& project) {
  std::set<std::filesystem::path> files;
  for (const Pass& pass : project.passes)
    for (std::size_t channel = 0; channel < pass.inputs.size(); ++channel)
      if (const Input input = bound_input(pass, channel); input.kind == InputKind::music)
        files.insert(input.files.front());
  return files;
}

}  // namespace

bool has_sound(const Project& project) {
  return !project.muted && (find_sound(project) >= 0 || !music_files(project).empty());
}

VideoSound::VideoSound(const Project& project, const Schedule& schedule, Player& player)
    : samples_per_frame_(sound_rate / schedule.fps),
      first_(static_cast<std::int64_t>(std::llround(schedule.t0 * sound_rate))) {
  if (find_sound(project) >= 0) pass_.emplace(player, shader_date(schedule.date, 0.0), first_);
  for (const auto& file : music_files(project))
    files_.push_back(std::make_unique<media::AudioFile>(file, sound_rate));
}

const std::vector<float>& VideoSound::next_frame() {
  ++frames_;
  const auto end = static_cast<std::int64_t>(std::llround(static_cast<double>(frames_) * samples_per_frame_));
  mix_.assign(static_cast<std::size_t>(2 * (end - done_)), 0.0F);
  part_.resize(mix_.size());
  const auto add = [&] {
    std::transform(mix_.begin(), mix_.end(), part_.begin(), mix_.begin(), std::plus<>());
  };
  if (pass_) {
    pass_->read(part_);
    add();
  }
  for (const auto& file : files_) {
    file->read(first_ + done_, part_);
    add();
  }
  for (float& sample : mix_) sample = std::clamp(sample, -1.0F, 1.0F);
  done_ = end;
  return mix_;
}

}  // namespace shadertwin::app
