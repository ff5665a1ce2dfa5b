// A device that draws nothing and writes down what it is asked for, and small projects to play on it.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/player/player.h"

namespace shadertwin {

using Lines = std::vector<std::string>;

// Writes down what it is asked for. Textures are named by their number, in the order in which they were made.
class FakeDevice final : public Device {
 public:
  struct Surface {
    Texture texels;  // of a target: none
    bool mipmaps = false;
    bool cube = false;
  };
  struct Draw : DrawCall {
    explicit Draw(const DrawCall& call) : DrawCall(call), bound(call.channels.begin(), call.channels.end()) {}
    std::vector<ChannelBinding> bound;  // `channels` ends with the call
  };

  using Device::Device;

  void begin() override { log.emplace_back("begin"); }
  void end() override { log.emplace_back("end"); }
  TextureId make_texture(Texture texels, bool mipmaps) override {
    surfaces.push_back({std::move(texels), mipmaps, false});
    return static_cast<TextureId>(surfaces.size() - 1);
  }
  void upload(TextureId texture, const Texture& texels) override {
    log.push_back("upload " + name(texture));
    surface(texture).texels = texels;
  }
  TextureId make_target(bool cube, bool mipmaps) override {
    surfaces.push_back({{}, mipmaps, cube});
    return static_cast<TextureId>(surfaces.size() - 1);
  }
  void resize(TextureId target, glm::ivec2 size, bool keep) override {
    log.push_back("resize " + name(target) + " to " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                  (keep ? " keep" : ""));
  }
  void clear(TextureId target) override { log.push_back("clear " + name(target)); }
  void draw(const DrawCall& call) override {
    log.push_back("draw " + project().passes[call.pass].name + " into " + name(call.target));
    draws.emplace_back(call);
  }
  Image read(TextureId target) override {
    log.push_back("read " + name(target));
    return {};
  }
  void finish() override {}
  std::string description() const override { return "fake"; }
  std::vector<std::string> warnings() const override { return {"a pass runs as fragments"}; }

  static std::string name(TextureId texture) { return std::to_string(static_cast<std::size_t>(texture)); }
  Surface& surface(TextureId texture) { return surfaces[static_cast<std::size_t>(texture)]; }
  // The texture on a channel in the last draw of a pass.
  TextureId bound(std::size_t pass, std::size_t channel) const {
    return last_draw(pass).bound.at(channel).texture;
  }
  const Draw& last_draw(std::size_t pass) const {
    for (std::size_t i = draws.size(); i-- > 0;)
      if (draws[i].pass == pass) return draws[i];
    throw std::out_of_range("the pass was not drawn");
  }
  // What was asked for since the last call.
  Lines take() { return std::exchange(log, {}); }

  Lines log;
  std::vector<Surface> surfaces;
  std::vector<Draw> draws;
};

inline Pass named(const std::string& name, PassKind kind) {
  Pass pass;
  pass.name = name;
  pass.kind = kind;
  return pass;
}

inline Input reads(int pass, MinFilter filter = MinFilter::linear) {
  Input input;
  input.kind = InputKind::pass;
  input.pass = pass;
  input.sampler.min = filter;
  return input;
}

inline Input of_kind(InputKind kind) {
  Input input;
  input.kind = kind;
  return input;
}

// Buffer A (0) reads itself and is read by the Image (1).
inline Project accumulating(Dialect dialect = Dialect::shadertoy) {
  Project project;
  project.dialect = dialect;
  project.passes = {named("A", PassKind::buffer), named("Image", PassKind::image)};
  for (Pass& pass : project.passes) pass.inputs[0] = reads(0);
  return project;
}

inline Frame frame_of(int index, int width = 4, int height = 3) {
  Frame frame;
  frame.index = index;
  frame.width = width;
  frame.height = height;
  frame.time = 2.0;
  return frame;
}

// A player, with the device that it plays on.
struct Played {
  explicit Played(const Project& project) : Played(std::make_unique<FakeDevice>(project)) {}
  explicit Played(std::unique_ptr<FakeDevice> made) : device(*made), player(std::move(made)) {
    device.take();
  }

  FakeDevice& device;
  Player player;
};

constexpr TextureId id(std::size_t number) {
  return static_cast<TextureId>(number);
}

}  // namespace shadertwin
