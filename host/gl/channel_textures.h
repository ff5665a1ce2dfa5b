// The textures behind those channels that don't read a pass: files, the keyboard, what moves by itself.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/gl/objects.h"
#include "host/gl/textures.h"
#include "host/player/moving_input.h"
#include "host/project/host_rules.h"

namespace shadertwin::gl {

struct ChannelTexture {
  BoundTexture bound;
  glm::vec3 size{0.0F};                 // iChannelResolution
  const MovingInput* moving = nullptr;  // what iChannelTime is of
};

class ChannelTextures {
 public:
  ChannelTextures(const Functions& gl, const Project& project)
      : gl_(gl), project_(project), rules_(host_rules(project)), moving_(project) {}

  // Loads what is bound to a channel, any kind of input but a pass; each file goes to the GPU once. Throws
  // Error(file).
  ChannelTexture load(const Input& input);
  BoundTexture keyboard();
  // Brings the keyboard and what moves to the frame.
  void update(const Frame& frame);
  const std::vector<std::string>& warnings() const { return moving_.warnings(); }

 private:
  struct Picture {
    Texture texture;  // the texels are dropped after the upload
    TextureObject object;
  };
  struct Moving {
    TextureObject object;
    bool mipmaps = false;
  };

  Picture& picture(const Input& input);
  BoundTexture unbound(GLenum target);
  // A buffer that is not there reads as one that was never drawn: zero, alpha too.
  BoundTexture missing_pass();
  void upload_keyboard(const Frame& frame);
  void upload_again(const Moving& moving, const Texture& texture);

  const Functions& gl_;
  const Project& project_;
  HostRules rules_;
  std::map<GLenum, TextureObject> unbound_;
  std::map<std::string, Picture> pictures_;
  MovingInputs moving_;
  std::map<const MovingInput*, Moving> moving_textures_;
  TextureObject keyboard_;
  TextureObject missing_pass_;
};

}  // namespace shadertwin::gl
