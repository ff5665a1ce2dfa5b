// Runs a project's passes on OpenGL.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/gl/context.h"
#include "host/gl/objects.h"
#include "host/gl/pass_timers.h"
#include "host/gl/program.h"
#include "host/gl/program_uniforms.h"
#include "host/gl/surface.h"
#include "host/player/device.h"
#include "host/player/player.h"
#include "host/project/project.h"
#include "host/text/pipeline.h"

namespace shadertwin::gl {

// How fragments run. A pass that can't run as compute (it uses derivatives, say) falls back to a fragment
// program.
enum class Dispatch {
  automatic,  // compute on NVIDIA GPUs, whose data-centre models have few units for fragments; else fragment
  fragment,
  compute,
};

struct PlayerOptions {
  Dispatch dispatch = Dispatch::automatic;
  bool timers = false;  // measure every pass on the GPU
  // What to compile for a pass, in the order in which it is tried. One that comes later means a warning.
  std::function<std::vector<PassSource>(const Project&, const Pass&, const ShowsFault&)> sources =
      driver_sources;
};

class GlDevice final : public Device {
 public:
  // Compiles every pass. Throws Error(shader).
  GlDevice(std::unique_ptr<Context> context, const Project& project, const PlayerOptions& options);
  ~GlDevice() override;

  void begin() override { context_->make_current(); }
  void end() override { gl_.Flush(); }
  TextureId make_texture(Texture texels, bool mipmaps) override;
  void upload(TextureId texture, const Texture& texels) override;
  TextureId make_target(bool cube, bool mipmaps) override;
  void resize(TextureId target, glm::ivec2 size, bool keep) override;
  void clear(TextureId target) override;
  void draw(const DrawCall& call) override;
  Image read(TextureId target) override;
  void finish() override;
  // Empty without PlayerOptions::timers or timer queries.
  std::vector<double> milliseconds() override;
  std::string description() const override;
  std::vector<std::string> warnings() const override { return warnings_; }

  Context& context() { return *context_; }
  // OpenGL's name of a texture; that of a target is GL_TEXTURE_2D or _CUBE_MAP.
  GLuint name(TextureId texture) const { return surface(texture).texture(); }
  // Copies a target of `source`, whose context shares its objects with this one, to one of the same kind and
  // size.
  void copy(const GlDevice& source, TextureId from, TextureId to);

 private:
  struct CompiledPass {
    std::optional<Program> program;
    std::optional<ProgramUniforms> uniforms;
    bool compute = false;
    GLint face = -1;    // of a cubemap pass
    GLint origin = -1;  // of a compute program
  };

  void make_program(std::size_t index, const PassSource& source, Dispatch dispatch);
  void warn_as_written(const std::string& pass, const std::string& reason);
  void compile(std::size_t index, Dispatch dispatch, const std::vector<PassSource>& sources);

  Surface& surface(TextureId id) { return surfaces_[static_cast<std::size_t>(id)]; }
  const Surface& surface(TextureId id) const { return surfaces_[static_cast<std::size_t>(id)]; }
  TextureId add(Surface surface);
  GLuint sampler(const Sampler& sampler);
  void empty_unit_0();
  void bind_channels(const CompiledPass& pass, std::span<const ChannelBinding> channels);
  void dispatch(const CompiledPass& pass, const Surface& target);
  void draw_triangles(const CompiledPass& pass, const Surface& target, bool clear, bool own_vertices);

  std::unique_ptr<Context> context_;  // before every object that lives in it
  const Functions& gl_;
  VertexArrayObject vertex_array_;
  std::vector<CompiledPass> passes_;
  std::vector<Surface> surfaces_;
  std::array<SamplerObject, 36> samplers_;  // one for each setting that was asked for
  std::vector<std::string> warnings_;
  bool warned_as_written_ = false;
  std::optional<PassTimers> timers_;
};

// Compiles every pass and loads every input. Throws Error(shader), Error(file).
std::unique_ptr<Player> make_player(std::unique_ptr<Context> context, const Project& project,
                                    const PlayerOptions& options = {});

}  // namespace shadertwin::gl
