// Screenshots and recordings, under names that are not taken.
#pragma once

#include <optional>
#include <string>

#include "host/image/image.h"
#include "host/view/recorder.h"

namespace shadertwin::view {

class Capture {
 public:
  // Files are BASE_0001.png and so on, from the first number under which there is nothing.
  explicit Capture(std::string base) : base_(std::move(base)) {}

  // Writes a PNG and an EXR; returns their name without extension. Throws Error(file).
  std::string screenshot(const Image& image) const;

  bool recording() const { return recorder_.has_value(); }
  int recorded() const { return recorder_.has_value() ? recorder_->frames() : -1; }
  // Frames go to BASE_recording_0001/frame_0000.png and so on. Throws Error(file).
  void start();
  void add(Image image);
  // Waits until all is written, and says what was.
  std::string stop();

 private:
  std::string free_name(const std::string& base) const;

  std::string base_;
  std::optional<Recorder> recorder_;
};

}  // namespace shadertwin::view
