// What a shader's samplers and uniforms are bound to.
#pragma once

#include <array>
#include <deque>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "host/player/device.h"
#include "host/player/uniforms.h"
#include "host/project/project.h"
#include "reference/twin/abi.h"
#include "reference/twin/surface.h"

namespace shadertwin::twin {

// The uniforms of a pass as a twin asks for them.
class UniformList {
 public:
  // `custom_values`: of `custom`, in order; empty: those that the project gives. All stay where they are.
  UniformList(const Uniforms& values, const std::vector<CustomUniform>& custom,
              std::span<const std::array<float, 4>> custom_values);
  void add(const char* name, int value);
  void add_sampler(const char* name, const void* sampler);
  const UniformValue* data() const { return values_.data(); }
  int size() const { return static_cast<int>(values_.size()); }

 private:
  std::vector<UniformValue> values_;
  std::deque<std::array<int, 4>> integers_;  // storage that stays in place
};

// The samplers of one pass.
class Channels {
 public:
  void bind(std::size_t channel, const Surface& surface, const Sampler& sampler);
  // Whether one of them chooses its texels by the level of detail.
  bool need_lod() const;
  void add_to(UniformList& uniforms) const;

 private:
  using AnySampler = std::variant<std::monostate, glsl::sampler2D, glsl::sampler3D, glsl::samplerCube>;
  std::array<AnySampler, keyboard_channel + 1> samplers_;
};

}  // namespace shadertwin::twin
