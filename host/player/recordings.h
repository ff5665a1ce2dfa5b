// What is heard of the files on a project's channels: music, and the sound of videos.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/media/audio_file.h"
#include "host/project/project.h"

namespace shadertwin {

// Whether the project has a Sound pass, music, or a video with sound, and is not muted. Throws Error(file).
bool has_sound(const Project& project);

// Every file once, whatever number of channels reads it, as loud as it is, repeated as its channel repeats
// it: a video begins again with its pictures. None of a project that is muted.
class Recordings {
 public:
  // Throws Error(file).
  explicit Recordings(const Project& project);

  // Adds samples `first` to `first` + stereo.size() / 2 - 1, sound_rate of them a second from iTime 0 on,
  // left and right in turn; before 0 there is silence.
  void add(std::int64_t first, std::span<float> stereo);

 private:
  struct Recording {
    std::unique_ptr<media::AudioFile> file;
    std::int64_t round = 0;  // samples until a video begins again; 0: the file's own
  };

  // As much of a video as lies in one round.
  void read_round(const Recording& recording, std::int64_t first, std::span<float> stereo);

  std::vector<Recording> recordings_;
  std::vector<float> part_;
};

}  // namespace shadertwin
