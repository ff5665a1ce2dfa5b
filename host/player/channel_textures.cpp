#include "host/player/channel_textures.h"

#include "host/player/keyboard.h"

namespace shadertwin {

ChannelTexture ChannelTextures::load(const Input& input) {
  switch (info(input.kind).source) {
    case InputSource::still:
      return still(input);
    case InputSource::keyboard:
      return keyboard();
    default:
      break;
  }
  if (const MovingInput* source = moving_inputs_.open(input)) return moving(input, *source);
  return {.texture = empty(input)};
}

ChannelTexture ChannelTextures::still(const Input& input) {
  const bool mipmaps = input.sampler.uses_mipmaps();
  std::string key = std::to_string(static_cast<int>(input.kind)) + (mipmaps ? " mipmaps" : "") +
                    (input.sampler.vflip ? " flipped" : "") + (input.red_only ? " red" : "");
  for (const auto& path : input.files) key += '\n' + path.string();
  const auto found = still_.find(key);
  if (found != still_.end()) return found->second;
  Texture texels = load_texture(input);
  const glm::vec3 size = channel_size(project_, input, &texels, {0, 0});
  const ChannelTexture loaded{device_.make_texture(std::move(texels), mipmaps), size};
  return still_.emplace(std::move(key), loaded).first->second;
}

ChannelTexture ChannelTextures::moving(const Input& input, const MovingInput& source) {
  const bool mipmaps = input.sampler.uses_mipmaps();
  const auto [entry, is_new] = moving_.try_emplace({&source, mipmaps});
  if (is_new) entry->second = device_.make_texture(source.texture(), mipmaps);
  return {entry->second, channel_size(project_, input, &source.texture(), {0, 0}), &source};
}

// One texel (0, 0, 0, 1), as browsers have it.
TextureId ChannelTextures::empty(const Input& input) {
  const SamplerShape shape = shape_of(project_, input);
  const auto alpha = static_cast<std::byte>(rules_.empty_alpha);
  const auto [entry, is_new] = empty_.try_emplace(shape);
  if (!is_new) return entry->second;
  Texture texel{.width = 1,
                .height = 1,
                .is_volume = shape == SamplerShape::volume,
                .faces = shape == SamplerShape::cube ? 6 : 1,
                .data = {}};
  texel.data.resize(texel.texel_bytes() * static_cast<std::size_t>(texel.faces));
  for (std::size_t i = 3; i < texel.data.size(); i += 4) texel.data[i] = alpha;
  return entry->second = device_.make_texture(std::move(texel), false);
}

TextureId ChannelTextures::undrawn(const Input& input, glm::ivec2 frame_size) {
  const auto [entry, is_new] = undrawn_.try_emplace(input.undrawn);
  Undrawn& undrawn = entry->second;
  if (is_new) undrawn.texture = device_.make_target(shape_of(project_, input) == SamplerShape::cube, false);
  const glm::ivec2 size(channel_size(project_, input, nullptr, frame_size));
  if (undrawn.size != size) device_.resize(undrawn.texture, size, false);
  undrawn.size = size;
  return undrawn.texture;
}

ChannelTexture ChannelTextures::keyboard() {
  if (!keyboard_) keyboard_ = device_.make_texture(keyboard_texture({}, rules_), false);
  Input input;
  input.kind = InputKind::keyboard;
  return {*keyboard_, channel_size(project_, input, nullptr, {0, 0})};
}

void ChannelTextures::update(const Frame& frame) {
  if (keyboard_) device_.upload(*keyboard_, keyboard_texture(frame.keyboard, rules_));
  moving_inputs_.update(frame, [this](const MovingInput& input) {
    for (const bool mipmaps : {false, true})
      if (const auto found = moving_.find({&input, mipmaps}); found != moving_.end())
        device_.upload(found->second, input.texture());
  });
}

}  // namespace shadertwin
