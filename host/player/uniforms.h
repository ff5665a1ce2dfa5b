// The built-in uniforms of both dialects, with the values that a frame gives them. Every player sets these
// and no others, so that they can't differ.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>

#include "host/player/frame.h"
#include "host/project/project.h"

namespace shadertwin {

// Size in texels of what is bound to a channel; zero when nothing is.
using ChannelSizes = std::array<glm::vec3, max_channels>;
// Seconds of playback of what moves on a channel, else zero.
using ChannelTimes = std::array<float, 4>;

struct Uniforms {
  glm::vec3 iResolution;  // of the pass: z is 1
  float iTime;
  float iTimeDelta;
  float iFrameRate;
  int iFrame;
  glm::vec4 iDate;
  glm::vec4 iMouse;
  glm::vec4 iMouseButton;
  float iSampleRate;
  float iChannelTime[4];
  glm::vec3 iChannelResolution[max_channels];
  glm::mat4 iViewMatrix;
  float iTimeOffset;  // sound passes
  int iSampleOffset;
};

struct UniformField {
  const char* name;
  UniformType type;
  int count;           // above 1: an array
  std::size_t offset;  // in Uniforms
};

// Name, type and place of every member of Uniforms.
std::span<const UniformField> uniform_fields();

// `size`: of the pass's target in pixels.
Uniforms uniforms_for(const Project& project, const Pass& pass, const Frame& frame, glm::ivec2 size,
                      const ChannelSizes& channels, const ChannelTimes& times = {});

// Of block `block` of a sound pass, which knows no frame: where it begins, and the date in whole seconds.
Uniforms uniforms_for_sound(int block, const glm::vec4& date, const ChannelSizes& channels);

}  // namespace shadertwin
