#include "host/gl/gl_device.h"

#include <algorithm>
#include <utility>

#include "host/base/error.h"
#include "host/gl/driver_faults.h"
#include "host/gl/textures.h"
#include "host/project/kinds.h"
#include "host/text/render.h"

namespace shadertwin::gl {

namespace {

constexpr std::array<GLfloat, 4> transparent_black{};

}  // namespace

GlDevice::GlDevice(std::unique_ptr<Context> context, const Project& project, const PlayerOptions& options)
    : Device(project), context_(std::move(context)), gl_(context_->functions()) {
  context_->make_current();
  vertex_array_ = VertexArrayObject(gl_);
  gl_.BindVertexArray(vertex_array_.name());
  gl_.Disable(GL_DITHER);
  passes_.resize(project.passes.size());
  // An error in any pass keeps shadertoy.com from playing any other, the sound among them.
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    const Pass& pass = this->project().passes[i];
    compile(i, traits(pass).every_frame ? options.dispatch : Dispatch::fragment,
            options.sources(this->project(), pass, [this](Fault fault) { return shows_fault(gl_, fault); }));
  }
  if (options.timers) timers_.emplace(*context_, passes_.size());
}

GlDevice::~GlDevice() {
  context_->make_current();
}

// --- Compiling --------------------------------------------------------------

void GlDevice::make_program(std::size_t index, const PassSource& source, Dispatch dispatch) {
  const Pass& pass = project().passes[index];
  CompiledPass& compiled = passes_[index];
  const DeviceInfo& device = context_->info();
  if (dispatch == Dispatch::automatic)
    dispatch = device.compute && device.vendor.find("NVIDIA") != std::string::npos ? Dispatch::compute
                                                                                   : Dispatch::fragment;
  if (dispatch == Dispatch::compute) {
    std::string why = "this device has no compute shaders";
    compiled.compute = device.compute && can_run_as_compute(pass, &why);
    if (!compiled.compute) warnings_.push_back(pass.name + ": warning: runs as fragments: " + why);
  }
  compiled.program = compiled.compute ? Program::compute(gl_, project(), pass, source)
                                      : Program::fragment(gl_, project(), pass, source);
}

// Once, for the first such pass.
void GlDevice::warn_as_written(const std::string& pass, const std::string& reason) {
  if (std::exchange(warned_as_written_, true)) return;
  warnings_.push_back(pass +
                      ": warning: runs as written, so what it leaves undefined is the driver's choice: " +
                      reason.substr(0, reason.find('\n')));
}

void GlDevice::compile(std::size_t index, Dispatch dispatch, const std::vector<PassSource>& sources) {
  CompiledPass& compiled = passes_[index];
  const std::string& name = project().passes[index].name;
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
  else if (project().undefined == Undefined::zero && !project().precise && sources.size() == 1)
    warn_as_written(name, "the text can't be read for rewriting it, although the driver takes it");
  compiled.uniforms.emplace(gl_, *compiled.program, project());
  compiled.face = compiled.program->uniform("shadertwin_face");
  compiled.origin = compiled.program->uniform("shadertwin_origin");
}

// --- Textures ---------------------------------------------------------------

TextureId GlDevice::add(Surface surface) {
  surfaces_.push_back(std::move(surface));
  return static_cast<TextureId>(surfaces_.size() - 1);
}

TextureId GlDevice::make_texture(Texture texels, bool mipmaps) {
  return add(Surface(*context_, texels, mipmaps));
}

void GlDevice::upload(TextureId texture, const Texture& texels) {
  surface(texture).upload(texels);
}

TextureId GlDevice::make_target(bool cube, bool mipmaps) {
  return add(Surface(*context_, cube, mipmaps));
}

void GlDevice::resize(TextureId target, glm::ivec2 size, bool keep) {
  const DeviceInfo& device = context_->info();
  if (std::max(size.x, size.y) > device.max_size)
    throw Error(ExitStatus::usage,
                device.name + " draws at most " + std::to_string(device.max_size) + " pixels wide and high");
  surface(target).resize(size, keep);
}

void GlDevice::clear(TextureId target) {
  surface(target).clear();
}

void GlDevice::copy(const GlDevice& source, TextureId from, TextureId to) {
  surface(to).copy(source.surface(from));
}

Image GlDevice::read(TextureId target) {
  context_->make_current();
  return surface(target).read();
}

GLuint GlDevice::sampler(const Sampler& sampler) {
  const auto index = (static_cast<std::size_t>(sampler.min) * 2 + static_cast<std::size_t>(sampler.mag)) * 3 +
                     static_cast<std::size_t>(sampler.wrap);
  SamplerObject& object = samplers_.at(index);
  if (object.name() == 0) object = make_sampler(gl_, sampler);
  return object.name();
}

// --- Drawing ----------------------------------------------------------------

void GlDevice::draw(const DrawCall& call) {
  const CompiledPass& pass = passes_[call.pass];
  const Pass& source = project().passes[call.pass];
  const Surface& target = surface(call.target);
  const bool timed = timers_ && !call.warm_up && traits(source).every_frame;
  if (timed) timers_->begin(call.pass);
  gl_.UseProgram(pass.program->name());
  pass.uniforms->set(call.uniforms, call.custom_uniforms);
  // Samplers that nothing sets read unit 0: empty, unless it is a channel, and not what was bound there last,
  // which may be the very target.
  const bool may_be_unset = source.vertex.has_value() ||
                            std::ranges::any_of(source.other_uniforms, [](const auto& u) { return !u.set; });
  if (may_be_unset && !pass.uniforms->samples(0)) empty_unit_0();
  bind_channels(pass, call.channels);
  if (pass.compute)
    dispatch(pass, target);
  else
    draw_triangles(pass, target, call.clear, source.vertex.has_value());
  target.make_mipmaps();
  if (timed) timers_->end(call.pass);
}

void GlDevice::empty_unit_0() {
  gl_.ActiveTexture(GL_TEXTURE0);
  for (const GLenum kind : {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) gl_.BindTexture(kind, 0);
  gl_.BindSampler(0, 0);
}

void GlDevice::bind_channels(const CompiledPass& pass, std::span<const ChannelBinding> channels) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!pass.uniforms->samples(i)) continue;
    const Surface& texture = surface(channels[i].texture);
    const auto unit = static_cast<GLuint>(i);
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(texture.kind(), texture.texture());
    gl_.BindSampler(unit, sampler(channels[i].sampler));
  }
}

// Such a pass discards nothing.
void GlDevice::dispatch(const CompiledPass& pass, const Surface& target) {
  gl_.BindImageTexture(compute_target_binding, target.texture(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl_.Uniform2i(pass.origin, 0, 0);
  const auto groups = [](int pixels) { return static_cast<GLuint>((pixels + group_size - 1) / group_size); };
  gl_.DispatchCompute(groups(target.size().x), groups(target.size().y), 1);
  gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT);
}

void GlDevice::draw_triangles(const CompiledPass& pass, const Surface& target, bool clear,
                              bool own_vertices) {
  gl_.Viewport(0, 0, target.size().x, target.size().y);
  if (own_vertices) gl_.Enable(GL_CULL_FACE);
  for (int face = 0; face < target.faces(); ++face) {
    target.bind(face);
    if (pass.face >= 0) gl_.Uniform1i(pass.face, face);
    if (clear) gl_.ClearBufferfv(GL_COLOR, 0, transparent_black.data());
    gl_.DrawArrays(GL_TRIANGLES, 0, own_vertices ? 6 : 3);
  }
  if (own_vertices) gl_.Disable(GL_CULL_FACE);
}

void GlDevice::finish() {
  context_->make_current();
  gl_.Finish();
}

std::string GlDevice::description() const {
  const bool compute =
      std::any_of(passes_.begin(), passes_.end(), [](const CompiledPass& pass) { return pass.compute; });
  return context_->info().name + (compute ? "/compute: " : "/fragment: ") + context_->info().renderer;
}

std::vector<double> GlDevice::milliseconds() {
  context_->make_current();
  return timers_ ? timers_->milliseconds() : std::vector<double>();
}

std::unique_ptr<Player> make_player(std::unique_ptr<Context> context, const Project& project,
                                    const PlayerOptions& options) {
  return std::make_unique<Player>(std::make_unique<GlDevice>(std::move(context), project, options));
}

}  // namespace shadertwin::gl
