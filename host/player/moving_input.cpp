#include "host/player/moving_input.h"

#include "host/player/audio_input.h"
#include "host/player/video_input.h"
#include "host/project/kinds.h"

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
  const InputKindInfo& kind = info(input.wanted());
  if (kind.source != InputSource::moving) return nullptr;
  if (kind.is_audio) return open_audio_input(project_, input, warnings_);
  return kind.files != 0 ? open_video_input(input, warnings_) : open_webcam_input(input, warnings_);
}

}  // namespace shadertwin
