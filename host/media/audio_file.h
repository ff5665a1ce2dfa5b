// A file of sound, played again and again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace shadertwin::media {

// Whether there is sound in a file of sound or moving pictures. Throws Error(file).
bool has_sound(const std::filesystem::path& file);

class AudioFile {
 public:
  // Any format that libav decodes; of a film the sound. `rate`: samples a second that read() gives. The file
  // is looked through, but decoded when read() first comes to a place. Throws Error(file) for what is
  // missing, no sound, damaged, shorter than it says, or longer than an hour.
  AudioFile(const std::filesystem::path& file, int rate);
  ~AudioFile();

  // Samples `first` to `first` + stereo.size() / 2 - 1, left and right in turn, of the file repeated without
  // end; before sample 0 is silence. One channel is both; more than two are mixed as Web Audio does.
  void read(std::int64_t first, std::span<float> stereo);
  // Left + right times this is the sound in one channel, as Web Audio mixes it.
  float mono_gain() const;
  // Length of one round in seconds.
  double seconds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shadertwin::media
