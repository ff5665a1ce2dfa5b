// What runs the passes of a project: a GPU, or the CPU twin. A few plain verbs over textures that the device
// numbers; when which of them is called is the Player's business.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/player/inputs.h"
#include "host/player/uniforms.h"
#include "host/project/project.h"

namespace shadertwin {

// A texture of one device, valid as long as the device is.
enum class TextureId : std::size_t {};

// What a channel of a pass reads.
struct ChannelBinding {
  TextureId texture{};
  Sampler sampler;
};

// The place of the extension's iKeyboard behind the numbered channels.
constexpr std::size_t keyboard_channel = max_channels;

// One pass, drawn into every pixel of a target and every face of it.
struct DrawCall {
  std::size_t pass = 0;  // index into Project::passes
  int index = 0;         // of the frame, or of the block of sound
  TextureId target{};
  // Pixels that the shader discards become transparent black, else they stay as they are.
  bool clear = false;
  bool warm_up = false;  // drawn before frame 0 (ping_pong.h)
  Uniforms uniforms{};
  // Values of Project::uniforms, in their order. Empty: those that the project gives.
  std::span<const std::array<float, 4>> custom_uniforms;
  // Entry N is iChannelN; the one behind them, if the pass has it, is iKeyboard.
  std::span<const ChannelBinding> channels;
};

class Device {
 public:
  // A device has compiled every pass of one project when it is made, or throws Error(shader).
  explicit Device(const Project& project) : project_(with_shared_samplers(project)) {}
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  // The project with the samplers that its passes are really read with.
  const Project& project() const { return project_; }

  // Work begins: a frame, a block of sound, loading. All verbs but read() and finish() stand between begin()
  // and end(), in one thread. An exception may take the place of end().
  virtual void begin() = 0;
  virtual void end() = 0;

  // A texture to be sampled, with its smaller levels if `mipmaps`.
  virtual TextureId make_texture(Texture texels, bool mipmaps) = 0;
  // New texels for a two-dimensional texture, of the size and format of the old ones.
  virtual void upload(TextureId texture, const Texture& texels) = 0;
  // A texture to be drawn into and sampled; `cube`: six faces. It has no pixels yet.
  virtual TextureId make_target(bool cube, bool mipmaps) = 0;
  // Gives a target `size` pixels: transparent black but, if `keep`, for what it held from the lower left
  // corner up. Throws Error(usage) for more than the device can draw, Error(device) if it can't draw into
  // float32 RGBA.
  virtual void resize(TextureId target, glm::ivec2 size, bool keep) = 0;
  // Makes a target transparent black; nothing if it has no pixels.
  virtual void clear(TextureId target) = 0;
  // Returns before the work is done where the device allows it. Throws Error(failed) when it takes too long.
  virtual void draw(const DrawCall& call) = 0;

  // The pixels of a target, bit for bit; six faces stand one above the other, +X lowest. Waits for them.
  virtual Image read(TextureId target) = 0;
  // Waits until everything has been drawn.
  virtual void finish() = 0;
  // Milliseconds that each pass took by the device's own clock when it was last measured, -1 if it never was.
  // Empty: the device measures nothing.
  virtual std::vector<double> milliseconds() { return {}; }

  // One line for people: renderer, version, and how fragments run.
  virtual std::string description() const = 0;
  // One line each for the passes that could not run as asked for.
  virtual std::vector<std::string> warnings() const = 0;

 private:
  Project project_;
};

}  // namespace shadertwin
