// Inputs whose picture changes from frame to frame by itself: music, a microphone, video, a webcam. Every
// player uploads what they hold and no other, so that they can't differ.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/player/frame.h"
#include "host/project/project.h"

namespace shadertwin {

class MovingInput {
 public:
  virtual ~MovingInput() = default;

  // Brings texture() and time() to what `frame` sees; whether texture() changed. To be called once for each
  // frame, in their order: some inputs depend on the frames before. Throws Error(file).
  virtual bool update(const Frame& frame) = 0;
  // Always of the size and format that it had first.
  virtual const Texture& texture() const = 0;
  // iChannelTime: seconds of playback.
  virtual double time() const = 0;
};

// The moving inputs of a project, each opened once, whatever number of channels reads it.
class MovingInputs {
 public:
  explicit MovingInputs(const Project& project) : project_(project) {}

  // Null for an input of another kind, and for one that can't be had here: a warning says why. Throws
  // Error(file).
  MovingInput* open(const Input& input);
  // What open() gave is updated for the frame, and `changed(input)` is called for each whose texels are new.
  template <class Changed>
  void update(const Frame& frame, const Changed& changed) {
    for (const auto& [key, input] : inputs_)
      if (input != nullptr && input->update(frame)) changed(*input);
  }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::unique_ptr<MovingInput> make(const Input& input);

  const Project& project_;
  std::map<std::string, std::unique_ptr<MovingInput>> inputs_;
  std::vector<std::string> warnings_;
};

}  // namespace shadertwin
