#include "host/player/uniforms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/project/host_rules.h"
#include "host/project/kinds.h"

namespace shadertwin {

namespace {

#define SHADERTWIN_FIELD(type, name, count)                   \
  UniformField {                                              \
#name, UniformType::type, count, offsetof(Uniforms, name) \
  }
constexpr std::array fields = {
    SHADERTWIN_FIELD(float3, iResolution, 1),
    SHADERTWIN_FIELD(float1, iTime, 1),
    SHADERTWIN_FIELD(float1, iTimeDelta, 1),
    SHADERTWIN_FIELD(float1, iFrameRate, 1),
    SHADERTWIN_FIELD(int1, iFrame, 1),
    SHADERTWIN_FIELD(float4, iDate, 1),
    SHADERTWIN_FIELD(float4, iMouse, 1),
    SHADERTWIN_FIELD(float4, iMouseButton, 1),
    SHADERTWIN_FIELD(float1, iSampleRate, 1),
    SHADERTWIN_FIELD(float1, iChannelTime, 4),
    SHADERTWIN_FIELD(float3, iChannelResolution, max_channels),
    SHADERTWIN_FIELD(mat4, iViewMatrix, 1),
    SHADERTWIN_FIELD(float1, iTimeOffset, 1),
    SHADERTWIN_FIELD(int1, iSampleOffset, 1),
};
#undef SHADERTWIN_FIELD

}  // namespace

std::span<const UniformField> uniform_fields() {
  return fields;
}

Uniforms uniforms_for(const Project& project, const Pass& pass, const Frame& frame, glm::ivec2 size,
                      const ChannelSizes& channels, const ChannelTimes& times) {
  Uniforms u{};
  u.iResolution = glm::vec3(size, 1.0F);
  u.iTime = static_cast<float>(frame.time);
  u.iTimeDelta = static_cast<float>(frame.time_delta);
  u.iFrameRate = static_cast<float>(frame.frame_rate);
  u.iFrame = frame.index;
  u.iDate = frame.date;
  u.iMouse = frame.mouse;
  u.iMouseButton = frame.mouse_button;
  std::copy(times.begin(), times.end(), u.iChannelTime);
  // Where there is no audio context from the start, the first audio input makes one.
  bool audio = host_rules(project).always_has_audio;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    u.iChannelResolution[i] = channels[i];
    audio = audio || info(pass.inputs[i].kind).is_audio;
  }
  u.iSampleRate = audio ? static_cast<float>(sound_rate) : 0.0F;
  u.iViewMatrix = project.first_person_controls ? frame.view : glm::mat4(1.0F);
  return u;
}

Uniforms uniforms_for_sound(int block, const glm::vec4& date, const ChannelSizes& channels) {
  Uniforms u{};
  u.iResolution = glm::vec3(sound_block_side, sound_block_side, 1.0F);
  u.iDate = glm::vec4(date.x, date.y, date.z, std::floor(date.w));
  u.iSampleRate = static_cast<float>(sound_rate);
  u.iSampleOffset = block * sound_block_samples;
  u.iTimeOffset = static_cast<float>(static_cast<double>(u.iSampleOffset) / sound_rate);
  std::copy(channels.begin(), channels.end(), u.iChannelResolution);
  return u;
}

}  // namespace shadertwin
