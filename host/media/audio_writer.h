// Sound into a file of its own.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "host/base/output_format.h"

namespace shadertwin::media {

// What AudioWriter writes.
std::vector<OutputFormat> audio_formats();
// Whether AudioWriter knows this extension.
bool can_write_audio(const std::filesystem::path& file);

// Stereo, by the extension: .wav keeps the floats bit for bit, .flac has 24 bits. The file
// appears under its name when finish() is called, whole; never, if it is not. The same samples give the same
// bytes.
class AudioWriter {
 public:
  // `rate`: samples a second. Throws Error(usage) for another extension, Error(file) if it can't be written.
  AudioWriter(const std::filesystem::path& file, int rate);
  ~AudioWriter();

  // Left and right in turn, in [-1, 1]. Throws Error(file).
  void write(std::span<const float> stereo);
  // Throws Error(file).
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shadertwin::media
