#include "reference/twin/channels.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "host/base/assert.h"
#include "host/player/inputs.h"
#include "host/player/keyboard.h"

namespace shadertwin::twin {
namespace {

constexpr std::array<const char*, Channels::keyboard + 1> channel_names = {
    "iChannel0", "iChannel1", "iChannel2", "iChannel3", "iChannel4", "iChannel5",
    "iChannel6", "iChannel7", "iChannel8", "iChannel9", "iKeyboard"};

constexpr Sampler nearest{MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};

int scalar_count(UniformType type) {
  switch (type) {
    case UniformType::float1:
    case UniformType::int1:
      return 1;
    case UniformType::float2:
    case UniformType::int2:
      return 2;
    case UniformType::float3:
    case UniformType::int3:
      return 3;
    case UniformType::float4:
    case UniformType::int4:
      return 4;
    case UniformType::mat4:
      return 16;
  }
  return 1;
}

bool is_integer(UniformType type) {
  return type >= UniformType::int1 && type <= UniformType::int4;
}

}  // namespace

bool uses_mipmaps(const Sampler& sampler) {
  return sampler.min != MinFilter::nearest && sampler.min != MinFilter::linear;
}

Picture::Picture(Texture texture, bool mipmaps) : texture_(std::move(texture)), mipmaps_(mipmaps) {
  finish_drawing();
}

void Picture::resize(int width, int height, int faces, bool keeps) {
  Texture fresh;
  fresh.format = Texture::Format::rgba32f;
  fresh.width = width;
  fresh.height = height;
  fresh.faces = faces;
  fresh.data.resize(fresh.texel_bytes() * static_cast<std::size_t>(width) * height * faces);
  if (keeps && texture_.width > 0) {
    const std::size_t row = fresh.texel_bytes() * static_cast<std::size_t>(std::min(width, texture_.width));
    for (int y = 0; y < std::min(height, texture_.height); ++y)
      std::memcpy(&fresh.data[fresh.texel_bytes() * static_cast<std::size_t>(width) * y],
                  &texture_.data[fresh.texel_bytes() * static_cast<std::size_t>(texture_.width) * y], row);
  }
  texture_ = std::move(fresh);
  finish_drawing();
}

void Picture::clear() {
  std::fill(texture_.data.begin(), texture_.data.end(), std::byte{0});
  if (texture_.width > 0) finish_drawing();
}

float* Picture::values() {
  return reinterpret_cast<float*>(texture_.data.data());
}

void Picture::round_from(const std::vector<double>& wide) {
  SHADERTWIN_ASSERT_EQ(wide.size() * sizeof(float), texture_.data.size());
  std::transform(wide.begin(), wide.end(), values(), [](double value) { return static_cast<float>(value); });
}

void Picture::copy_to(float* rgba) const {
  std::memcpy(rgba, texture_.data.data(), texture_.data.size());
}

void Picture::finish_drawing() {
  image_ = std::make_unique<glsl::TextureImage>(texture_, mipmaps_);
}

const Picture& PictureLibrary::load(const Input& input) {
  const bool mipmaps = uses_mipmaps(input.sampler);
  std::string key = std::string(mipmaps ? "mipmaps" : "plain") + (input.sampler.vflip ? " flipped" : "") +
                    (input.red_only ? " red" : "");
  for (const auto& file : input.files) key += '\n' + file.string();
  auto found = pictures_.find(key);
  if (found == pictures_.end())
    found = pictures_.emplace(std::move(key), Picture(load_texture(input), mipmaps)).first;
  return found->second;
}

const MovingPictures::Moving* MovingPictures::load(const Input& input) {
  const MovingInput* moving = inputs_.open(input);
  if (moving == nullptr) return nullptr;
  Moving& entry = pictures_[moving];
  const bool mipmaps = entry.picture.has_mipmaps() || uses_mipmaps(input.sampler);
  if (entry.input == nullptr || mipmaps != entry.picture.has_mipmaps())
    entry = {moving, Picture(moving->texture(), mipmaps)};
  return &entry;
}

void MovingPictures::update(const Frame& frame) {
  inputs_.update(frame, [this](const MovingInput& input) {
    Picture& picture = pictures_.at(&input).picture;
    picture = Picture(input.texture(), picture.has_mipmaps());
  });
}

Keyboard::Keyboard(Dialect dialect) : rules_(host_rules(dialect)) {
  update(Frame{});
}

void Keyboard::update(const Frame& frame) {
  picture_ = Picture(keyboard_texture(frame.keyboard, rules_), false);
}

UniformList::UniformList(const Uniforms& values, const std::vector<CustomUniform>& custom,
                         const std::vector<std::array<float, 4>>& custom_values) {
  for (const UniformField& field : uniform_fields()) {
    const auto kind = is_integer(field.type) ? UniformValue::Kind::int32 : UniformValue::Kind::float32;
    values_.push_back({field.name, kind, reinterpret_cast<const char*>(&values) + field.offset,
                       scalar_count(field.type) * field.count});
  }
  for (std::size_t i = 0; i < custom.size(); ++i) {
    const std::array<float, 4>& value = custom_values.empty() ? custom[i].value : custom_values[i];
    // The twin's own variable is an integer where it has to be.
    values_.push_back({custom[i].name.c_str(), UniformValue::Kind::float32, value.data(), 4});
  }
}

void UniformList::add(const char* name, int value) {
  integers_.push_back({value});
  values_.push_back({name, UniformValue::Kind::int32, integers_.back().data(), 1});
}

void UniformList::add_sampler(const char* name, const void* sampler) {
  values_.push_back({name, UniformValue::Kind::sampler, sampler, 1});
}

void Channels::bind(std::size_t channel, const Picture& picture, const Sampler& sampler) {
  if (picture.texture().faces == 6)
    samplers_[channel] = glsl::bindcube(picture.image(), sampler);
  else if (picture.texture().is_volume)
    samplers_[channel] = glsl::bind3d(picture.image(), sampler);
  else
    samplers_[channel] = glsl::bind2d(picture.image(), sampler);
}

void Channels::bind_keyboard(std::size_t channel, const Picture& picture) {
  bind(channel, picture, nearest);
}

bool Channels::need_lod() const {
  return std::any_of(samplers_.begin(), samplers_.end(), [](const AnySampler& any) {
    return std::visit(
        [](const auto& sampler) {
          if constexpr (std::is_same_v<std::decay_t<decltype(sampler)>, std::monostate>)
            return false;
          else
            return glsl::needs_lod(sampler);
        },
        any);
  });
}

void Channels::add_to(UniformList& uniforms) const {
  for (std::size_t i = 0; i < samplers_.size(); ++i) {
    std::visit(
        [&](const auto& sampler) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(sampler)>, std::monostate>)
            uniforms.add_sampler(channel_names[i], &sampler);
        },
        samplers_[i]);
  }
}

}  // namespace shadertwin::twin
