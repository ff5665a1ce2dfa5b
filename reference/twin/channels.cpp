#include "reference/twin/channels.h"

#include <algorithm>
#include <utility>

namespace shadertwin::twin {
namespace {

constexpr std::array<const char*, keyboard_channel + 1> channel_names = {
    "iChannel0", "iChannel1", "iChannel2", "iChannel3", "iChannel4", "iChannel5",
    "iChannel6", "iChannel7", "iChannel8", "iChannel9", "iKeyboard"};

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

UniformList::UniformList(const Uniforms& values, const std::vector<CustomUniform>& custom,
                         std::span<const std::array<float, 4>> custom_values) {
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

void Channels::bind(std::size_t channel, const Surface& surface, const Sampler& sampler) {
  if (surface.faces() == 6)
    samplers_[channel] = glsl::bindcube(surface.image(), sampler);
  else if (surface.texture().is_volume)
    samplers_[channel] = glsl::bind3d(surface.image(), sampler);
  else
    samplers_[channel] = glsl::bind2d(surface.image(), sampler);
  std::visit(
      [&](auto& bound) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(bound)>, std::monostate>)
          bound.bound.shadows = surface.shadow_views();
      },
      samplers_[channel]);
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
