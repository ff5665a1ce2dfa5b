// Plays a project on a device: the one frame script of OpenGL and the CPU twin, so that they can't differ in
// the order of things, in what is kept and what is cleared, or in what a channel reads.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/player/channel_textures.h"
#include "host/player/device.h"
#include "host/player/frame.h"
#include "host/player/ping_pong.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"

namespace shadertwin {

class Player {
 public:
  // Plays the project that the device has compiled. Loads every input but those of a sound pass. Throws
  // Error(file).
  explicit Player(std::unique_ptr<Device> device);

  // Draws every pass once. Buffers keep what they hold between calls; a frame with index 0 starts from
  // cleared buffers. Returns before the work is done where the device allows it. Throws what Device::resize()
  // and Device::draw() throw.
  void render(const Frame& frame);

  // What pass `pass` (an index into Project::passes) drew last, float32 RGBA bit for bit. Waits for the
  // device. A cubemap pass gives its six faces below one another, +X at the bottom.
  Image read(int pass);

  // Block 0, 1, 2 ... of the project's sound pass: sound_block_side x sound_block_side samples, as project.h
  // lays them out. `date` is iDate. What pictures are made of stays as it is; what moves by itself is not
  // bound. Throws Error(shader), Error(file), and Error(usage) if there is no sound pass.
  Image sound_block(int block, const glm::vec4& date);

  // Waits until everything that was asked for has been drawn.
  void finish() { device_->finish(); }

  // As Device::milliseconds() gives them.
  std::vector<double> milliseconds() { return device_->milliseconds(); }

  // One line for people: renderer, version, and how fragments run.
  std::string description() const { return device_->description(); }

  // One line each: passes that could not run as asked for, inputs that can't be had here.
  std::vector<std::string> warnings() const;

  // The device's texture that holds what pass `pass` drew last.
  TextureId texture(int pass) const;

  // Takes over what the passes of the same name and kind hold in `earlier`, so that a changed shader goes on
  // from there. `copy` copies a target of earlier's device to one of the same size here.
  void continue_from(Player& earlier, const std::function<void(TextureId from, TextureId to)>& copy);

 private:
  struct PassState {
    std::vector<TextureId> targets;
    glm::ivec2 size{0};
    std::vector<ChannelBinding> channels;
    std::vector<const MovingInput*> moving;  // on the first channels; null on those that stand still
    ChannelSizes sizes{};
  };

  // Whether a pass is a sound, which no frame draws.
  bool in_blocks(std::size_t pass) const { return !traits(device_->project().passes[pass]).every_frame; }
  void bind_inputs(std::size_t pass);
  void resize(glm::ivec2 size);
  void draw_passes(const Frame& frame);
  // What the pass `reader` reads of another one now.
  TextureId source_texture(std::size_t reader, const Input& input);
  void draw(std::size_t pass, int index, const Uniforms& uniforms,
            const std::vector<std::array<float, 4>>& custom_uniforms);

  std::unique_ptr<Device> device_;
  ChannelTextures textures_{*device_};
  HostRules rules_ = host_rules(device_->project());
  PingPong ping_pong_{device_->project()};
  std::vector<PassState> passes_;
  glm::ivec2 size_{0};
};

}  // namespace shadertwin
