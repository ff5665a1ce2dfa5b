#include "host/gl/gl_player.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "host/base/error.h"
#include "host/gl/channel_textures.h"
#include "host/gl/objects.h"
#include "host/gl/pass_timers.h"
#include "host/gl/program.h"
#include "host/gl/program_uniforms.h"
#include "host/gl/target.h"
#include "host/gl/textures.h"
#include "host/player/inputs.h"
#include "host/player/ping_pong.h"
#include "host/player/uniforms.h"
#include "host/text/render.h"

namespace shadertwin::gl {

namespace {

constexpr Sampler nearest{MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};

struct Channel {
  GLuint unit = 0;
  int pass = -1;  // that it reads
  SamplerObject sampler;
  ChannelTexture fixed;  // for everything but passes
};

struct PassState {
  explicit PassState(Target drawn) : target(std::move(drawn)) {}

  Target target;
  std::optional<Program> program;
  std::optional<ProgramUniforms> uniforms;
  bool compute = false;
  GLint face = -1;    // of a cubemap pass
  GLint origin = -1;  // of a compute program
  std::vector<Channel> channels;
  ChannelSizes sizes{};
};

// Whether a pass reads `pass` by a filter that needs mipmaps of it.
bool needs_mipmaps(const Project& project, std::size_t pass) {
  for (const Pass& reader : project.passes)
    for (const Input& input : reader.inputs)
      if (input.kind == InputKind::pass && static_cast<std::size_t>(input.pass) == pass &&
          uses_mipmaps(input.sampler.min))
        return true;
  return false;
}

class GlPlayerImpl final : public GlPlayer {
 public:
  GlPlayerImpl(std::unique_ptr<Context> context, const Project& project, const PlayerOptions& options)
      : context_(std::move(context)), gl_(context_->functions()), project_(with_shared_samplers(project)) {
    context_->make_current();
    vertex_array_ = VertexArrayObject(gl_);
    gl_.BindVertexArray(vertex_array_.name());
    gl_.Disable(GL_DITHER);
    passes_.reserve(project_.passes.size());
    for (std::size_t i = 0; i < project_.passes.size(); ++i) {
      const PassKind kind = project_.passes[i].kind;
      passes_.emplace_back(Target(*context_, kind == PassKind::cubemap ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D,
                                  ping_pong_.targets(i), needs_mipmaps(project_, i)));
      // An error in any pass keeps shadertoy.com from playing any other, the sound among them.
      const bool sound = kind == PassKind::sound;
      compile(i, sound ? Dispatch::fragment : options.dispatch,
              options.sources(project_, project_.passes[i]));
      if (!sound) bind_inputs(i);
    }
    if (options.timers) timers_.emplace(*context_, passes_.size());
  }

  ~GlPlayerImpl() override { context_->make_current(); }

  void render(const Frame& frame) override {
    context_->make_current();
    const auto warm_up = ping_pong_.begin(frame);
    resize({frame.width, frame.height});
    tell_sizes();
    if (frame.index == 0) clear();
    textures_.update(frame);
    if (warm_up) {
      draw_passes(*warm_up, false);
      ping_pong_.end_warm_up();
    }
    draw_passes(frame, timers_.has_value());
    gl_.Flush();
  }

  Image read(int pass) override {
    context_->make_current();
    const auto index = static_cast<std::size_t>(pass);
    return passes_.at(index).target.read(ping_pong_.front(index));
  }

  Image sound_block(int block, const glm::vec4& date) override {
    context_->make_current();
    const int pass = find_sound(project_);
    if (pass < 0) throw Error(ExitStatus::usage, "the shader has no Sound pass (mainSound)");
    const auto index = static_cast<std::size_t>(pass);
    PassState& state = passes_[index];
    if (state.target.size().x == 0) {
      bind_inputs(index);
      state.target.resize(glm::ivec2(sound_block_side), false);
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
    return passes_.at(index).target.texture(ping_pong_.front(index));
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
      if (source.kind() != target.kind() || source.size() != target.size() || source.size().x == 0) continue;
      const std::size_t last = old.ping_pong_.front(index);
      const bool alike = old.ping_pong_.targets(index) == ping_pong_.targets(i);
      ping_pong_.set_front(i, alike ? last : 0);
      for (std::size_t picture = 0; picture < ping_pong_.targets(i); ++picture)
        target.copy(source, alike ? picture : last, picture);
      target.make_mipmaps(ping_pong_.front(i));
    }
  }

  std::vector<double> milliseconds() override {
    context_->make_current();
    return timers_ ? timers_->milliseconds() : std::vector<double>();
  }

 private:
  void make_program(std::size_t index, const PassSource& source, Dispatch dispatch) {
    const Pass& pass = project_.passes[index];
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
    state.program = state.compute ? Program::compute(gl_, project_, pass, source)
                                  : Program::fragment(gl_, project_, pass, source);
  }

  // Once, for the first such pass.
  void warn_as_written(const std::string& pass, const std::string& reason) {
    if (std::exchange(warned_as_written_, true)) return;
    warnings_.push_back(pass +
                        ": warning: runs as written, so what it leaves undefined is the driver's choice: " +
                        reason.substr(0, reason.find('\n')));
  }

  void compile(std::size_t index, Dispatch dispatch, const std::vector<PassSource>& sources) {
    PassState& state = passes_[index];
    const std::string& name = project_.passes[index].name;
    std::string refusal;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const std::size_t warned = warnings_.size();
      try {
        make_program(index, sources[i], dispatch);
        break;
      } catch (const Error& error) {
        if (error.status() != ExitStatus::shader || i + 1 == sources.size()) throw;
        warnings_.resize(warned);
        refusal = error.what();
      }
    }
    if (!refusal.empty())
      warn_as_written(name, "the driver refuses the rewritten text: " + refusal);
    else if (project_.undefined == Undefined::zero && !project_.precise && sources.size() == 1)
      warn_as_written(name, "the text can't be read for rewriting it, although the driver takes it");
    state.uniforms.emplace(gl_, *state.program, project_);
    state.face = state.program->uniform("shadertwin_face");
    state.origin = state.program->uniform("shadertwin_origin");
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

  // Buffers keep, on shadertoy.com, the old pixels from the lower left corner up. The first of their two
  // pictures counts as the last one from then on, whichever was drawn last. A canvas is emptied.
  void resize(glm::ivec2 size) {
    if (size == size_) return;
    if (std::max(size.x, size.y) > context_->info().max_size)
      throw Error(ExitStatus::usage, context_->info().name + " draws at most " +
                                         std::to_string(context_->info().max_size) + " pixels wide and high");
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      Target& target = passes_[i].target;
      const glm::ivec2 wanted = target.kind() == GL_TEXTURE_CUBE_MAP ? glm::ivec2(cubemap_pass_size) : size;
      if (target.size() == wanted) continue;
      const bool keeps =
          project_.dialect == Dialect::shadertoy && project_.passes[i].kind == PassKind::buffer;
      target.resize(wanted, keeps);
      if (keeps) ping_pong_.set_front(i, 0);
    }
    size_ = size;
  }

  void tell_sizes() {
    for (std::size_t i = 0; i < passes_.size(); ++i)
      for (const Channel& channel : passes_[i].channels)
        if (channel.pass >= 0)
          passes_[i].sizes[channel.unit] = channel_size(project_, project_.passes[i].inputs[channel.unit],
                                                        nullptr, ping_pong_.reported_size());
  }

  void clear() {
    for (PassState& state : passes_) state.target.clear();
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
    draw(index,
         uniforms_for(project_, project_.passes[index], frame, state.target.size(), state.sizes, times),
         frame.uniforms);
  }

  void draw(std::size_t index, const Uniforms& values,
            const std::vector<std::array<float, 4>>& custom_values) {
    PassState& state = passes_[index];
    Target& target = state.target;
    const std::size_t back = ping_pong_.back(index);
    gl_.UseProgram(state.program->name());
    state.uniforms->set(values, custom_values);
    for (const Channel& channel : state.channels) {
      BoundTexture bound = channel.fixed.bound;
      if (channel.pass >= 0) {
        const auto source = static_cast<std::size_t>(channel.pass);
        const Target& read = passes_[source].target;
        bound = {read.kind(), read.texture(ping_pong_.read_by(index, source))};
      }
      bind(channel.unit, bound, channel.sampler.name());
    }

    if (state.compute) {
      gl_.BindImageTexture(compute_target_binding, target.texture(back), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                           GL_RGBA32F);
      gl_.Uniform2i(state.origin, 0, 0);
      const auto groups = [](int pixels) {
        return static_cast<GLuint>((pixels + group_size - 1) / group_size);
      };
      gl_.DispatchCompute(groups(target.size().x), groups(target.size().y), 1);
      gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                        GL_FRAMEBUFFER_BARRIER_BIT);
    } else {
      gl_.Viewport(0, 0, target.size().x, target.size().y);
      for (int face = 0; face < target.faces(); ++face) {
        target.bind(back, face);
        if (state.face >= 0) gl_.Uniform1i(state.face, face);
        // The extension clears every target before it draws, which shows where a shader discards.
        if (project_.dialect == Dialect::vscode) {
          constexpr std::array<GLfloat, 4> zero{};
          gl_.ClearBufferfv(GL_COLOR, 0, zero.data());
        }
        draw_triangles(project_.passes[index].vertex.has_value());
      }
    }
    ping_pong_.drawn(index);
    target.make_mipmaps(back);
  }

  void draw_triangles(bool own_vertices) {
    if (!own_vertices) return gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Enable(GL_CULL_FACE);
    gl_.DrawArrays(GL_TRIANGLES, 0, 6);
    gl_.Disable(GL_CULL_FACE);
  }

  void bind(GLuint unit, const BoundTexture& texture, GLuint sampler) {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(texture.target, texture.name);
    gl_.BindSampler(unit, sampler);
  }

  std::unique_ptr<Context> context_;  // before every object that lives in it
  const Functions& gl_;
  Project project_;
  VertexArrayObject vertex_array_;
  ChannelTextures textures_{gl_, project_};
  PingPong ping_pong_{project_};
  std::vector<PassState> passes_;
  glm::ivec2 size_{0};
  std::vector<std::string> warnings_;
  bool warned_as_written_ = false;
  std::optional<PassTimers> timers_;
};

}  // namespace

std::unique_ptr<GlPlayer> GlPlayer::create(std::unique_ptr<Context> context, const Project& project,
                                           const PlayerOptions& options) {
  return std::make_unique<GlPlayerImpl>(std::move(context), project, options);
}

}  // namespace shadertwin::gl
