#include "host/player/recordings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "host/media/video_reader.h"
#include "host/player/inputs.h"

namespace shadertwin {

namespace {

namespace fs = std::filesystem;

std::set<fs::path> files_of(const Project& project, InputKind kind) {
  std::set<fs::path> files;
  if (project.muted) return files;
  for (const Pass& pass : project.passes)
    for (std::size_t channel = 0; channel < pass.inputs.size(); ++channel)
      if (const Input input = bound_input(pass, channel); input.kind == kind)
        files.insert(input.files.front());
  return files;
}

}  // namespace

bool has_sound(const Project& project) {
  if (project.muted) return false;
  const auto videos = files_of(project, InputKind::video);
  return find_sound(project) >= 0 || !files_of(project, InputKind::music).empty() ||
         std::any_of(videos.begin(), videos.end(), media::has_sound);
}

Recordings::Recordings(const Project& project) {
  for (const fs::path& file : files_of(project, InputKind::music))
    recordings_.push_back({std::make_unique<media::AudioFile>(file, sound_rate)});
  for (const fs::path& file : files_of(project, InputKind::video))
    if (media::has_sound(file))
      recordings_.push_back({std::make_unique<media::AudioFile>(file, sound_rate),
                             std::llround(media::VideoReader(file, false).duration() * sound_rate)});
}

void Recordings::add(std::int64_t first, std::span<float> stereo) {
  part_.resize(stereo.size());
  for (const Recording& recording : recordings_) {
    const auto count = static_cast<std::int64_t>(stereo.size() / 2);
    if (recording.round <= 0 || first < 0) {
      recording.file->read(first, part_);
    } else {
      for (std::int64_t done = 0; done < count;) {
        const std::int64_t at = (first + done) % recording.round;
        const std::int64_t piece = std::min(count - done, recording.round - at);
        read_round(recording, at,
                   std::span(part_).subspan(static_cast<std::size_t>(2 * done),
                                            static_cast<std::size_t>(2 * piece)));
        done += piece;
      }
    }
    std::transform(stereo.begin(), stereo.end(), part_.begin(), stereo.begin(), std::plus<>());
  }
}

// The sound may end before the pictures do.
void Recordings::read_round(const Recording& recording, std::int64_t first, std::span<float> stereo) {
  const auto there = static_cast<std::int64_t>(std::llround(recording.file->seconds() * sound_rate)) - first;
  const auto heard = static_cast<std::size_t>(
      std::clamp(2 * there, std::int64_t{0}, static_cast<std::int64_t>(stereo.size())));
  if (heard > 0) recording.file->read(first, stereo.first(heard));
  std::fill(stereo.begin() + static_cast<std::ptrdiff_t>(heard), stereo.end(), 0.0F);
}

}  // namespace shadertwin
