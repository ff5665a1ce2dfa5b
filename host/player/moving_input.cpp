#include "host/player/moving_input.h"

#include "host/player/audio_input.h"
#include "host/player/video_input.h"

namespace shadertwin {

MovingInput* MovingInputs::open(const Input& input) {
  std::string key =
      std::to_string(static_cast<int>(input.wanted())) + (input.sampler.vflip ? " flipped" : "");
  for (const auto& file : input.files) key += '\n' + file.string();
  auto found = inputs_.find(key);
  if (found == inputs_.end()) found = inputs_.emplace(std::move(key), make(input)).first;
  return found->second.get();
}

std::unique_ptr<MovingInput> MovingInputs::make(const Input& input) {
  switch (input.wanted()) {
    case InputKind::music:
    case InputKind::microphone:
      return open_audio_input(project_, input, warnings_);
    case InputKind::video:
      return open_video_input(input, warnings_);
    case InputKind::webcam:
      return open_webcam_input(input, warnings_);
    default:
      return nullptr;
  }
}

}  // namespace shadertwin
