#include "host/player/sound.h"

#include <cmath>

#include "host/base/assert.h"
#include "host/base/error.h"
#include "host/project/kinds.h"

namespace shadertwin {

Project sound_only(const Project& project) {
  const int sound = find_sound(project);
  if (sound < 0) throw Error(ExitStatus::usage, "the shader has no Sound pass (mainSound)");
  Project result = project;
  result.passes = {project.passes[static_cast<std::size_t>(sound)]};
  // Passes are not bound to a sound, and these are no longer there.
  for (Input& input : result.passes[0].inputs) {
    if (input.kind != InputKind::pass) continue;
    input.undrawn = pass_read(project, input)->kind;
    input.missing = InputKind::undrawn;
    input.kind = InputKind::none;
    input.pass = -1;
  }
  return result;
}

void Sound::read(std::span<float> stereo) {
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2, ++next_) {
    if (next_ < 0) {
      stereo[i] = stereo[i + 1] = 0.0F;
      continue;
    }
    const int block = static_cast<int>(next_ / sound_block_samples);
    if (block != block_) {
      samples_ = blocks_(block);
      block_ = block;
    }
    SHADERTWIN_ASSERT_EQ(samples_.rgba.size(), std::size_t{4} * sound_block_samples);
    const float* sample = &samples_.rgba[static_cast<std::size_t>(next_ % sound_block_samples) * 4];
    stereo[i] = checked(sample[0]);
    stereo[i + 1] = checked(sample[1]);
  }
}

float Sound::checked(float value) {
  if (std::isnan(value)) {
    ++nan_values_;
    return 0.0F;
  }
  if (std::abs(value) <= 1.0F) return value;
  ++clipped_values_;
  return std::copysign(1.0F, value);
}

}  // namespace shadertwin
