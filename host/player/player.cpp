#include "host/player/player.h"

#include <algorithm>
#include <utility>

#include "host/base/error.h"

namespace shadertwin {

namespace {

constexpr Sampler nearest{MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};

// Whether a pass reads `pass` by a filter that needs mipmaps of it.
bool needs_mipmaps(const Project& project, std::size_t pass) {
  for (const Pass& reader : project.passes)
    for (const Input& input : reader.inputs)
      if (input.kind == InputKind::pass && static_cast<std::size_t>(input.pass) == pass &&
          input.sampler.uses_mipmaps())
        return true;
  return false;
}

// Whether an input is a pass, drawn or not there.
bool is_pass(const Input& input) {
  const InputSource source = info(input.kind).source;
  return source == InputSource::pass || source == InputSource::undrawn;
}

}  // namespace

Player::Player(std::unique_ptr<Device> device) : device_(std::move(device)) {
  const Project& project = device_->project();
  passes_.resize(project.passes.size());
  device_->begin();
  for (std::size_t i = 0; i < passes_.size(); ++i)
    for (std::size_t target = 0; target < ping_pong_.targets(i); ++target)
      passes_[i].targets.push_back(
          device_->make_target(traits(project.passes[i]).faces == 6, needs_mipmaps(project, i)));
  for (std::size_t i = 0; i < passes_.size(); ++i)
    if (!in_blocks(i)) bind_inputs(i);
  device_->end();
}

void Player::bind_inputs(std::size_t index) {
  const Pass& pass = device_->project().passes[index];
  PassState& state = passes_[index];
  state.channels.clear();
  state.moving.clear();
  for (std::size_t i = 0; i < max_channels; ++i) {
    const Input input = bound_input(pass, i);
    const bool keyboard = input.kind == InputKind::keyboard;
    // What is read of a pass changes with every frame, and its size with the frame's.
    const ChannelTexture loaded = is_pass(input) ? ChannelTexture{} : textures_.load(input);
    state.channels.push_back({loaded.texture, keyboard ? nearest : input.sampler});
    state.moving.push_back(loaded.moving);
    state.sizes[i] = loaded.size;
  }
  if (pass.keyboard) state.channels.push_back({textures_.keyboard().texture, nearest});
}

void Player::render(const Frame& frame) {
  device_->begin();
  const auto warm_up = ping_pong_.begin(frame);
  resize({frame.width, frame.height});
  if (frame.index == 0)
    for (const PassState& state : passes_)
      for (const TextureId target : state.targets) device_->clear(target);
  textures_.update(frame);
  if (warm_up) {
    draw_passes(*warm_up);
    ping_pong_.end_warm_up();
  }
  draw_passes(frame);
  device_->end();
}

// Buffers may keep the old pixels from the lower left corner up. The first of their two
// targets counts as the last one from then on, whichever was drawn last. A canvas is emptied.
void Player::resize(glm::ivec2 size) {
  if (size == size_) return;
  const Project& project = device_->project();
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    if (in_blocks(i)) continue;
    const PassTraits& kind = traits(project.passes[i]);
    const glm::ivec2 wanted = target_size(kind, size);
    if (passes_[i].size == wanted) continue;
    const bool keep = kind.keeps_pixels && rules_.keeps_pixels_on_resize;
    for (const TextureId target : passes_[i].targets) device_->resize(target, wanted, keep);
    if (keep) ping_pong_.set_front(i, 0);
    passes_[i].size = wanted;
  }
  size_ = size;
}

void Player::draw_passes(const Frame& frame) {
  const Project& project = device_->project();
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    if (in_blocks(i)) continue;
    const Pass& pass = project.passes[i];
    PassState& state = passes_[i];
    ChannelTimes times{};
    for (std::size_t channel = 0; channel < max_channels; ++channel) {
      const Input& input = pass.inputs[channel];
      if (is_pass(input)) {
        state.channels[channel].texture = source_texture(i, input);
        state.sizes[channel] = channel_size(project, input, nullptr, ping_pong_.reported_size());
      } else if (state.moving[channel] != nullptr && channel < times.size()) {
        times[channel] = static_cast<float>(state.moving[channel]->time());
      }
    }
    draw(i, frame.index, uniforms_for(project, pass, frame, state.size, state.sizes, times), frame.uniforms);
  }
}

TextureId Player::source_texture(std::size_t reader, const Input& input) {
  if (input.kind != InputKind::pass) return textures_.undrawn(input, size_);
  const auto source = static_cast<std::size_t>(input.pass);
  return passes_[source].targets[ping_pong_.read_by(reader, source)];
}

void Player::draw(std::size_t pass, int index, const Uniforms& uniforms,
                  const std::vector<std::array<float, 4>>& custom_uniforms) {
  PassState& state = passes_[pass];
  DrawCall call;
  call.pass = pass;
  call.index = index;
  call.target = state.targets[ping_pong_.back(pass)];
  call.clear = rules_.clears_targets;
  call.warm_up = ping_pong_.warming_up();
  call.uniforms = uniforms;
  call.custom_uniforms = custom_uniforms;
  call.channels = state.channels;
  device_->draw(call);
  ping_pong_.drawn(pass);
}

TextureId Player::texture(int pass) const {
  const auto index = static_cast<std::size_t>(pass);
  return passes_.at(index).targets[ping_pong_.front(index)];
}

Image Player::read(int pass) {
  return device_->read(texture(pass));
}

Image Player::sound_block(int block, const glm::vec4& date) {
  const int pass = find_sound(device_->project());
  if (pass < 0) throw Error(ExitStatus::usage, "the shader has no Sound pass (mainSound)");
  const auto index = static_cast<std::size_t>(pass);
  PassState& state = passes_[index];
  device_->begin();
  if (state.size.x == 0) {
    bind_inputs(index);
    state.size = glm::ivec2(sound_block_side);
    for (const TextureId target : state.targets) device_->resize(target, state.size, false);
  }
  draw(index, block, uniforms_for_sound(block, date, state.sizes), {});
  device_->end();
  return read(pass);
}

std::vector<std::string> Player::warnings() const {
  std::vector<std::string> all = device_->warnings();
  all.insert(all.end(), textures_.warnings().begin(), textures_.warnings().end());
  return all;
}

void Player::continue_from(Player& earlier, const std::function<void(TextureId from, TextureId to)>& copy) {
  const Project& project = device_->project();
  const Project& earlier_project = earlier.device_->project();
  earlier.finish();
  device_->begin();
  if (earlier.size_.x != 0) resize(earlier.size_);
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    const int found = find_pass(earlier_project, project.passes[i].name);
    if (found < 0) continue;
    const auto index = static_cast<std::size_t>(found);
    const PassState& source = earlier.passes_[index];
    if (traits(project.passes[i]).faces != traits(earlier_project.passes[index]).faces ||
        source.size != passes_[i].size || source.size.x == 0)
      continue;
    const std::size_t last = earlier.ping_pong_.front(index);
    const bool alike = source.targets.size() == passes_[i].targets.size();
    ping_pong_.set_front(i, alike ? last : 0);
    for (std::size_t target = 0; target < passes_[i].targets.size(); ++target)
      copy(source.targets[alike ? target : last], passes_[i].targets[target]);
  }
  device_->end();
}

}  // namespace shadertwin
