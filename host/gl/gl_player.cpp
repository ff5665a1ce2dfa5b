#include "host/gl/gl_player.h"

#include <algorithm>
#include <array>
#include <optional>

#include "host/base/error.h"
#include "host/gl/channel_textures.h"
#include "host/gl/objects.h"
#include "host/gl/pass_timers.h"
#include "host/gl/program.h"
#include "host/gl/textures.h"
#include "host/player/inputs.h"
#include "host/player/rounds.h"
#include "host/player/uniforms.h"
#include "host/project/compute_text.h"

namespace shadertwin::gl {

namespace {

constexpr GLuint keyboard_unit = max_channels;  // iKeyboard of the extension
constexpr Sampler nearest{MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};

// Where one uniform of a program goes, and where its value comes from.
struct UniformSlot {
  GLint location;
  UniformType type;
  int count;
  std::size_t offset;  // in Uniforms
};

void set_uniform(const Functions& gl, GLint location, UniformType type, int count, const void* value) {
  const auto* f = static_cast<const GLfloat*>(value);
  const auto* i = static_cast<const GLint*>(value);
  switch (type) {
    case UniformType::float1:
      gl.Uniform1fv(location, count, f);
      break;
    case UniformType::float2:
      gl.Uniform2fv(location, count, f);
      break;
    case UniformType::float3:
      gl.Uniform3fv(location, count, f);
      break;
    case UniformType::float4:
      gl.Uniform4fv(location, count, f);
      break;
    case UniformType::int1:
      gl.Uniform1iv(location, count, i);
      break;
    case UniformType::int2:
      gl.Uniform2iv(location, count, i);
      break;
    case UniformType::int3:
      gl.Uniform3iv(location, count, i);
      break;
    case UniformType::int4:
      gl.Uniform4iv(location, count, i);
      break;
    case UniformType::mat4:
      gl.UniformMatrix4fv(location, count, GL_FALSE, f);
      break;
  }
}

bool is_integer(UniformType type) {
  return type >= UniformType::int1 && type <= UniformType::int4;
}

// What a pass draws into: as many pictures as Rounds says.
struct Target {
  GLenum kind = GL_TEXTURE_2D;
  glm::ivec2 size{0};
  bool mipmaps = false;
  std::array<TextureObject, 2> textures;
  std::array<FramebufferObject, 2> framebuffers;
};

struct Channel {
  GLuint unit = 0;
  int pass = -1;  // that it reads
  SamplerObject sampler;
  ChannelTexture fixed;  // for everything but passes
};

struct PassState {
  std::optional<Program> program;
  bool compute = false;
  std::vector<UniformSlot> uniforms;
  std::vector<GLint> custom;  // locations of Project::uniforms
  GLint face = -1;            // of a cubemap pass
  GLint origin = -1;          // of a compute program
  std::vector<Channel> channels;
  ChannelSizes sizes{};
  Target target;
};

class GlPlayerImpl final : public GlPlayer {
 public:
  GlPlayerImpl(std::unique_ptr<Context> context, const Project& project, const PlayerOptions& options)
      : context_(std::move(context)), gl_(context_->functions()), project_(with_shared_samplers(project)) {
    context_->make_current();
    vertex_array_ = VertexArrayObject(gl_);
    gl_.BindVertexArray(vertex_array_.name());
    gl_.Disable(GL_DITHER);
    passes_.resize(project_.passes.size());
    if (options.rewrite) rewritten_ = options.rewrite(project_);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      compile(i, options.dispatch);
      bind_inputs(i);
    }
    for (std::size_t i = 0; i < passes_.size(); ++i)
      passes_[i].target.kind =
          project_.passes[i].kind == PassKind::cubemap ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    for (const Pass& pass : project_.passes)
      for (const Input& input : pass.inputs)
        if (input.kind == InputKind::pass && uses_mipmaps(input.sampler.min))
          passes_[static_cast<std::size_t>(input.pass)].target.mipmaps = true;
    if (options.timers) timers_.emplace(*context_, passes_.size());
  }

  ~GlPlayerImpl() override { context_->make_current(); }

  void render(const Frame& frame) override {
    context_->make_current();
    const auto rehearsal = rounds_.begin(frame);
    resize({frame.width, frame.height});
    tell_sizes();
    if (frame.index == 0) clear();
    textures_.update(frame);
    if (rehearsal) {
      draw_passes(*rehearsal, false);
      rounds_.end_rehearsal();
    }
    draw_passes(frame, timers_.has_value());
    gl_.Flush();
  }

  Image read(int pass) override {
    context_->make_current();
    const auto index = static_cast<std::size_t>(pass);
    const Target& target = passes_.at(index).target;
    const std::size_t shown = rounds_.shown(index);
    const bool cube = target.kind == GL_TEXTURE_CUBE_MAP;
    const int faces = cube ? 6 : 1;
    Image image(target.size.x, target.size.y * faces);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffers[shown].name());
    for (int face = 0; face < faces; ++face) {
      if (cube) attach_face(target, shown, face);
      gl_.ReadPixels(0, 0, target.size.x, target.size.y, GL_RGBA, GL_FLOAT,
                     image.at(0, face * target.size.y));
    }
    if (gl_.GetError() != GL_NO_ERROR)
      throw Error(ExitStatus::device, context_->info().name + ": the picture can't be read back");
    return image;
  }

  Image sound_block(int block, const glm::vec4& date) override {
    context_->make_current();
    const int pass = find_sound(project_);
    if (pass < 0) throw Error(ExitStatus::usage, "the shader has no Sound pass (mainSound)");
    const auto index = static_cast<std::size_t>(pass);
    PassState& state = passes_[index];
    if (!state.program) {
      compile(index, Dispatch::fragment);
      bind_inputs(index);
      state.target.size = glm::ivec2(sound_block_side);
      make_picture(state.target, 0, state.target.size);
    }
    draw(index, uniforms_for_sound(block, date, state.sizes), {});
    return read(pass);
  }

  void finish() override {
    context_->make_current();
    gl_.Finish();
  }

  std::string description() const override {
    const bool compute =
        std::any_of(passes_.begin(), passes_.end(), [](const PassState& p) { return p.compute; });
    return context_->info().name + (compute ? "/compute: " : "/fragment: ") + context_->info().renderer;
  }

  GLuint texture(int pass) const override {
    const auto index = static_cast<std::size_t>(pass);
    return passes_.at(index).target.textures[rounds_.shown(index)].name();
  }
  Context& context() override { return *context_; }
  std::vector<std::string> warnings() const override {
    std::vector<std::string> all = warnings_;
    all.insert(all.end(), textures_.warnings().begin(), textures_.warnings().end());
    return all;
  }

  void continue_from(GlPlayer& earlier) override {
    auto& old = static_cast<GlPlayerImpl&>(earlier);
    old.finish();
    context_->make_current();
    if (old.size_.x != 0) resize(old.size_);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      const int found = find_pass(old.project_, project_.passes[i].name);
      if (found < 0) continue;
      const auto index = static_cast<std::size_t>(found);
      const Target& source = old.passes_[index].target;
      Target& target = passes_[i].target;
      if (source.kind != target.kind || source.size != target.size || source.size.x == 0) continue;
      const std::size_t last = old.rounds_.shown(index);
      const bool alike = old.rounds_.pictures(index) == rounds_.pictures(i);
      rounds_.show(i, alike ? last : 0);
      for (std::size_t picture = 0; picture < rounds_.pictures(i); ++picture)
        copy(source, alike ? picture : last, target, picture);
      make_mipmaps(target, rounds_.shown(i));
    }
  }

  std::vector<double> milliseconds() override {
    context_->make_current();
    return timers_ ? timers_->milliseconds() : std::vector<double>();
  }

 private:
  void make_program(std::size_t index, const Pass& pass, Dispatch dispatch) {
    PassState& state = passes_[index];
    const DeviceInfo& device = context_->info();
    if (dispatch == Dispatch::automatic)
      dispatch = device.compute && device.vendor.find("NVIDIA") != std::string::npos ? Dispatch::compute
                                                                                     : Dispatch::fragment;
    if (dispatch == Dispatch::compute) {
      std::string why = "this device has no compute shaders";
      state.compute = device.compute && can_run_as_compute(pass, &why);
      if (!state.compute) warnings_.push_back(pass.name + ": warning: runs as fragments: " + why);
    }
    state.program =
        state.compute ? Program::compute(gl_, project_, pass) : Program::fragment(gl_, project_, pass);
  }

  void compile(std::size_t index, Dispatch dispatch) {
    PassState& state = passes_[index];
    const std::size_t warned = warnings_.size();
    try {
      make_program(index, rewritten_ ? rewritten_->passes[index] : project_.passes[index], dispatch);
    } catch (const Error& error) {
      if (!rewritten_ || error.status() != ExitStatus::shader) throw;
      warnings_.resize(warned);
      make_program(index, project_.passes[index], dispatch);
    }
    const Program& program = *state.program;
    gl_.UseProgram(program.name());
    for (const UniformField& field : uniform_fields())
      if (const GLint location = program.uniform(field.name); location >= 0)
        state.uniforms.push_back({location, field.type, field.count, field.offset});
    for (const CustomUniform& custom : project_.uniforms)
      state.custom.push_back(program.uniform(custom.name));
    state.face = program.uniform("shadertwin_face");
    state.origin = program.uniform("shadertwin_origin");
    for (std::size_t i = 0; i < max_channels; ++i)
      if (const GLint location = program.uniform("iChannel" + std::to_string(i)); location >= 0)
        gl_.Uniform1i(location, static_cast<GLint>(i));
    if (const GLint location = program.uniform("iKeyboard"); location >= 0)
      gl_.Uniform1i(location, static_cast<GLint>(keyboard_unit));
  }

  void set_custom(GLint location, UniformType type, const std::array<float, 4>& value) {
    if (location < 0) return;
    std::array<GLint, 4> integers{};
    for (std::size_t i = 0; i < 4; ++i) integers[i] = static_cast<GLint>(value[i]);
    if (is_integer(type))
      set_uniform(gl_, location, type, 1, integers.data());
    else
      set_uniform(gl_, location, type, 1, value.data());
  }

  void bind_inputs(std::size_t index) {
    const Pass& pass = project_.passes[index];
    PassState& state = passes_[index];
    for (std::size_t i = 0; i < max_channels; ++i) {
      const Input input = bound_input(pass, i);
      if (state.program->uniform("iChannel" + std::to_string(i)) < 0 && input.wanted() == InputKind::none)
        continue;
      Channel channel;
      channel.unit = static_cast<GLuint>(i);
      channel.pass = input.kind == InputKind::pass ? input.pass : -1;
      channel.sampler = make_sampler(gl_, input.kind == InputKind::keyboard ? nearest : input.sampler);
      // What is read of a pass changes with every frame, and its size with the frame's.
      if (input.kind != InputKind::pass) {
        channel.fixed = textures_.load(input);
        state.sizes[i] = channel.fixed.size;
      }
      state.channels.push_back(std::move(channel));
    }
    if (state.program->uniform("iKeyboard") >= 0) {
      Channel channel;
      channel.unit = keyboard_unit;
      channel.sampler = make_sampler(gl_, nearest);
      channel.fixed.bound = textures_.keyboard();
      state.channels.push_back(std::move(channel));
    }
  }

  void attach_face(const Target& target, std::size_t picture, int face) {
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                             static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face),
                             target.textures[picture].name(), 0);
  }

  // Makes one of the pictures of a target, black and transparent, and leaves it bound.
  void make_picture(Target& target, std::size_t picture, glm::ivec2 size) {
    target.textures[picture] = make_target(gl_, target.kind, size, target.mipmaps);
    target.framebuffers[picture] = FramebufferObject(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffers[picture].name());
    gl_.FramebufferTexture2D(
        GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
        target.kind == GL_TEXTURE_2D ? GL_TEXTURE_2D : static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X),
        target.textures[picture].name(), 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw Error(ExitStatus::device, context_->info().name + " can't draw into float32 RGBA");
    constexpr std::array<GLfloat, 4> zero{};
    gl_.ClearBufferfv(GL_COLOR, 0, zero.data());
  }

  // New targets of buffers keep, on shadertoy.com, the old pixels from the lower left corner up. The first of
  // their two pictures counts as the last one from then on, whichever was drawn last. A canvas is emptied.
  void resize(glm::ivec2 size) {
    if (size == size_) return;
    if (std::max(size.x, size.y) > context_->info().max_size)
      throw Error(ExitStatus::usage, context_->info().name + " draws at most " +
                                         std::to_string(context_->info().max_size) + " pixels wide and high");
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      Target& target = passes_[i].target;
      if (target.kind == GL_TEXTURE_CUBE_MAP && target.size.x != 0) continue;
      const glm::ivec2 new_size = target.kind == GL_TEXTURE_CUBE_MAP ? glm::ivec2(cubemap_pass_size) : size;
      const bool keeps =
          project_.dialect == Dialect::shadertoy && project_.passes[i].kind == PassKind::buffer;
      for (std::size_t picture = 0; picture < rounds_.pictures(i); ++picture) {
        Target old;
        std::swap(old.textures[picture], target.textures[picture]);
        std::swap(old.framebuffers[picture], target.framebuffers[picture]);
        make_picture(target, picture, new_size);
        if (target.size.x != 0 && keeps) {
          const glm::ivec2 common = glm::min(size, target.size);
          gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, old.framebuffers[picture].name());
          gl_.BlitFramebuffer(0, 0, common.x, common.y, 0, 0, common.x, common.y, GL_COLOR_BUFFER_BIT,
                              GL_NEAREST);
        }
        make_mipmaps(target, picture);
      }
      if (keeps) rounds_.show(i, 0);
      target.size = new_size;
    }
    size_ = size;
  }

  void tell_sizes() {
    for (std::size_t i = 0; i < passes_.size(); ++i)
      for (const Channel& channel : passes_[i].channels)
        if (channel.pass >= 0)
          passes_[i].sizes[channel.unit] = channel_size(project_, project_.passes[i].inputs[channel.unit],
                                                        nullptr, rounds_.reported_size());
  }

  void clear() {
    constexpr std::array<GLfloat, 4> zero{};
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      const PassState& state = passes_[i];
      if (state.target.size.x == 0) continue;
      for (std::size_t picture = 0; picture < rounds_.pictures(i); ++picture) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, state.target.framebuffers[picture].name());
        const int faces = state.target.kind == GL_TEXTURE_CUBE_MAP ? 6 : 1;
        for (int face = 0; face < faces; ++face) {
          if (faces == 6) attach_face(state.target, picture, face);
          gl_.ClearBufferfv(GL_COLOR, 0, zero.data());
        }
        make_mipmaps(state.target, picture);
      }
    }
  }

  void draw_passes(const Frame& frame, bool timed) {
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      if (timed) timers_->begin(i);
      draw(i, frame);
      if (timed) timers_->end(i);
    }
  }

  void draw(std::size_t index, const Frame& frame) {
    const PassState& state = passes_[index];
    ChannelTimes times{};
    for (const Channel& channel : state.channels)
      if (channel.fixed.moving != nullptr && channel.unit < times.size())
        times[channel.unit] = static_cast<float>(channel.fixed.moving->time());
    draw(index, uniforms_for(project_, project_.passes[index], frame, state.target.size, state.sizes, times),
         frame.uniforms);
  }

  void draw(std::size_t index, const Uniforms& values,
            const std::vector<std::array<float, 4>>& custom_values) {
    PassState& state = passes_[index];
    Target& target = state.target;
    const std::size_t back = rounds_.target(index);
    gl_.UseProgram(state.program->name());
    for (const UniformSlot& slot : state.uniforms)
      set_uniform(gl_, slot.location, slot.type, slot.count,
                  reinterpret_cast<const char*>(&values) + slot.offset);
    for (std::size_t i = 0; i < state.custom.size(); ++i) {
      const CustomUniform& custom = project_.uniforms[i];
      set_custom(state.custom[i], custom.type, i < custom_values.size() ? custom_values[i] : custom.value);
    }
    for (const Channel& channel : state.channels) {
      BoundTexture bound = channel.fixed.bound;
      if (channel.pass >= 0) {
        const auto source = static_cast<std::size_t>(channel.pass);
        const Target& read = passes_[source].target;
        bound = {read.kind, read.textures[rounds_.read_by(index, source)].name()};
      }
      bind(channel.unit, bound, channel.sampler.name());
    }

    if (state.compute) {
      gl_.BindImageTexture(compute_target_binding, target.textures[back].name(), 0, GL_FALSE, 0,
                           GL_WRITE_ONLY, GL_RGBA32F);
      gl_.Uniform2i(state.origin, 0, 0);
      const auto groups = [](int pixels) {
        return static_cast<GLuint>((pixels + group_size - 1) / group_size);
      };
      gl_.DispatchCompute(groups(target.size.x), groups(target.size.y), 1);
      gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                        GL_FRAMEBUFFER_BARRIER_BIT);
    } else {
      gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffers[back].name());
      gl_.Viewport(0, 0, target.size.x, target.size.y);
      const int faces = target.kind == GL_TEXTURE_CUBE_MAP ? 6 : 1;
      for (int face = 0; face < faces; ++face) {
        if (faces == 6) {
          attach_face(target, back, face);
          gl_.Uniform1i(state.face, face);
        }
        // The extension clears every target before it draws, which shows where a shader discards.
        if (project_.dialect == Dialect::vscode) {
          constexpr std::array<GLfloat, 4> zero{};
          gl_.ClearBufferfv(GL_COLOR, 0, zero.data());
        }
        draw_triangles(project_.passes[index].vertex.has_value());
      }
    }
    rounds_.drawn(index);
    make_mipmaps(target, back);
  }

  void draw_triangles(bool own_vertices) {
    if (!own_vertices) return gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Enable(GL_CULL_FACE);
    gl_.DrawArrays(GL_TRIANGLES, 0, 6);
    gl_.Disable(GL_CULL_FACE);
  }

  void make_mipmaps(const Target& target, std::size_t picture) {
    if (!target.mipmaps) return;
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(target.kind, target.textures[picture].name());
    gl_.GenerateMipmap(target.kind);
  }

  // `source` may belong to another player in the share group, whose framebuffers don't exist here.
  void copy(const Target& source, std::size_t from, const Target& target, std::size_t to) {
    const FramebufferObject reader(gl_);
    const int faces = target.kind == GL_TEXTURE_CUBE_MAP ? 6 : 1;
    for (int face = 0; face < faces; ++face) {
      gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffers[to].name());
      if (faces == 6) attach_face(target, to, face);
      gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, reader.name());
      gl_.FramebufferTexture2D(
          GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
          faces == 6 ? static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : GL_TEXTURE_2D,
          source.textures[from].name(), 0);
      gl_.BlitFramebuffer(0, 0, target.size.x, target.size.y, 0, 0, target.size.x, target.size.y,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
  }

  void bind(GLuint unit, const BoundTexture& texture, GLuint sampler) {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(texture.target, texture.name);
    gl_.BindSampler(unit, sampler);
  }

  std::unique_ptr<Context> context_;  // before every object that lives in it
  const Functions& gl_;
  Project project_;
  std::optional<Project> rewritten_;  // to be tried first
  VertexArrayObject vertex_array_;
  ChannelTextures textures_{gl_, project_};
  Rounds rounds_{project_};
  std::vector<PassState> passes_;
  glm::ivec2 size_{0};
  std::vector<std::string> warnings_;
  std::optional<PassTimers> timers_;
};

}  // namespace

std::unique_ptr<GlPlayer> GlPlayer::create(std::unique_ptr<Context> context, const Project& project,
                                           const PlayerOptions& options) {
  return std::make_unique<GlPlayerImpl>(std::move(context), project, options);
}

}  // namespace shadertwin::gl
