// Where the uniforms of a program go.
#pragma once

#include <array>
#include <bitset>
#include <span>
#include <vector>

#include "host/gl/program.h"
#include "host/player/device.h"
#include "host/player/uniforms.h"

namespace shadertwin::gl {

class ProgramUniforms {
 public:
  // Finds those that the program uses, and gives iChannelN the texture unit N, iKeyboard the one behind them
  // (keyboard_channel).
  ProgramUniforms(const Functions& gl, const Program& program, const Project& project);

  // Sets all but the samplers of the program, which must be in use. `custom`: values of Project::uniforms, by
  // index; those that it lacks get the project's.
  void set(const Uniforms& values, std::span<const std::array<float, 4>> custom) const;
  // Whether the program reads that channel.
  bool samples(std::size_t channel) const { return sampled_[channel]; }

 private:
  struct BuiltIn {
    GLint location;
    UniformType type;
    int count;
    std::size_t offset;  // in Uniforms
  };
  struct Custom {
    GLint location;
    UniformType type;
    std::size_t index;  // in Project::uniforms
    std::array<float, 4> value;
  };

  const Functions* gl_;
  std::vector<BuiltIn> built_in_;
  std::vector<Custom> custom_;
  std::bitset<keyboard_channel + 1> sampled_;
};

}  // namespace shadertwin::gl
