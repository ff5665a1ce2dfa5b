// What a shader's samplers and uniforms are bound to.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "host/player/frame.h"
#include "host/player/moving_input.h"
#include "host/player/uniforms.h"
#include "host/project/host_rules.h"
#include "reference/glsl/texture_image.h"
#include "reference/twin/abi.h"

namespace shadertwin::twin {

bool uses_mipmaps(const Sampler& sampler);

// Texels that shaders sample and passes draw.
class Picture {
 public:
  Picture() = default;
  Picture(Texture texture, bool mipmaps);

  // Float texels, `faces` of them below one another; the old ones stay, from the lower left corner up, if
  // `keeps`.
  void resize(int width, int height, int faces, bool keeps);
  void clear();
  float* values();
  void round_from(const std::vector<double>& wide);
  void copy_to(float* rgba) const;
  // Makes what was drawn visible to samplers.
  void finish_drawing();
  void want_mipmaps() { mipmaps_ = true; }
  bool has_mipmaps() const { return mipmaps_; }

  const Texture& texture() const { return texture_; }
  const glsl::TextureImage* image() const { return image_.get(); }

 private:
  Texture texture_;
  bool mipmaps_ = false;
  std::unique_ptr<glsl::TextureImage> image_;
};

// Each file is read once, whatever number of channels samples it.
class PictureLibrary {
 public:
  const Picture& load(const Input& input);

 private:
  std::map<std::string, Picture> pictures_;
};

// What moves by itself: music, video ...
class MovingPictures {
 public:
  explicit MovingPictures(const Project& project) : inputs_(project) {}
  // Null if there is nothing to show. The picture stays in place, but its image() changes with the frames.
  struct Moving {
    const MovingInput* input = nullptr;
    Picture picture;
  };
  const Moving* load(const Input& input);
  void update(const Frame& frame);
  const std::vector<std::string>& warnings() const { return inputs_.warnings(); }

 private:
  MovingInputs inputs_;
  std::map<const MovingInput*, Moving> pictures_;
};

// The keyboard as a texture, in the shape that its host gives it.
class Keyboard {
 public:
  explicit Keyboard(Dialect dialect);
  void update(const Frame& frame);
  const Picture& picture() const { return picture_; }

 private:
  HostRules rules_;
  Picture picture_;
};

// The uniforms of a pass as a twin asks for them.
class UniformList {
 public:
  // `custom_values`: of `custom`, in order; empty: those that the project gives. All stay where they are.
  UniformList(const Uniforms& values, const std::vector<CustomUniform>& custom,
              const std::vector<std::array<float, 4>>& custom_values);
  void add(const char* name, int value);
  void add_sampler(const char* name, const void* sampler);
  const UniformValue* data() const { return values_.data(); }
  int size() const { return static_cast<int>(values_.size()); }

 private:
  std::vector<UniformValue> values_;
  std::deque<std::array<int, 4>> integers_;  // storage that stays in place
};

// The samplers of one pass.
class Channels {
 public:
  static constexpr std::size_t keyboard = max_channels;  // iKeyboard of the extension

  void bind(std::size_t channel, const Picture& picture, const Sampler& sampler);
  void bind_keyboard(std::size_t channel, const Picture& picture);
  // Whether one of them chooses its texels by the level of detail.
  bool need_lod() const;
  void add_to(UniformList& uniforms) const;

 private:
  using AnySampler = std::variant<std::monostate, glsl::sampler2D, glsl::sampler3D, glsl::samplerCube>;
  std::array<AnySampler, max_channels + 1> samplers_;
};

}  // namespace shadertwin::twin
