// The textures behind those channels that don't read a pass: files, the keyboard, what moves by itself.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/player/device.h"
#include "host/player/moving_input.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"

namespace shadertwin {

struct ChannelTexture {
  TextureId texture{};
  glm::vec3 size{0.0F};                 // iChannelResolution
  const MovingInput* moving = nullptr;  // what iChannelTime is of
};

class ChannelTextures {
 public:
  // `device` must outlive this.
  explicit ChannelTextures(Device& device)
      : device_(device), project_(device.project()), rules_(host_rules(project_)), moving_inputs_(project_) {}

  // Loads what is bound to a channel, any kind of input but a pass that is there or not; each file goes to
  // the device once. Throws Error(file).
  ChannelTexture load(const Input& input);
  // A pass that the project lacks reads as one that was never drawn: zero, alpha too. `frame_size`: of the
  // project's pictures.
  TextureId undrawn(const Input& input, glm::ivec2 frame_size);
  // 256 texels wide, as high as the dialect has rows.
  ChannelTexture keyboard();
  // Brings the keyboard and what moves to the frame.
  void update(const Frame& frame);
  const std::vector<std::string>& warnings() const { return moving_inputs_.warnings(); }

 private:
  ChannelTexture still(const Input& input);
  ChannelTexture moving(const Input& input, const MovingInput& source);
  TextureId empty(const Input& input);

  struct Undrawn {
    TextureId texture{};
    glm::ivec2 size{0};
  };

  Device& device_;
  const Project& project_;
  HostRules rules_;
  MovingInputs moving_inputs_;
  std::map<std::string, ChannelTexture> still_;
  std::map<std::pair<const MovingInput*, bool>, TextureId> moving_;  // with and without mipmaps
  std::map<SamplerShape, TextureId> empty_;
  std::map<PassKind, Undrawn> undrawn_;
  std::optional<TextureId> keyboard_;
};

}  // namespace shadertwin
