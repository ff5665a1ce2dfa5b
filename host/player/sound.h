// The samples of a project's sound pass, one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin {

// How long a sound of shadertoy.com's is. Here the shader is asked for as much as is wanted.
constexpr double sound_seconds = 180.0;

// The project without its pictures, for those who want to hear it only. Throws Error(usage) if it has no
// sound pass.
Project sound_only(const Project& project);

class Sound {
 public:
  // Gives block 0, 1, 2 ... as Player::sound_block() does.
  using Blocks = std::function<Image(int block)>;

  // `first`: number of the first sample, sound_rate of them a second; before 0 there is silence.
  explicit Sound(Blocks blocks, std::int64_t first = 0) : blocks_(std::move(blocks)), next_(first) {}
  // `player` plays a project with a sound pass and must outlive this. `date`: iDate.
  Sound(Player& player, const glm::vec4& date, std::int64_t first = 0)
      : Sound([&player, date](int block) { return player.sound_block(block, date); }, first) {}

  // The number of the sample that read() gives next.
  void seek(std::int64_t first) { next_ = first; }

  // The next stereo.size() / 2 samples, left and right in turn, in [-1, 1]: what the shader gives beyond is
  // clipped, as on shadertoy.com, and NaN is 0. Throws what Player::sound_block() throws.
  void read(std::span<float> stereo);

  // How many values so far were NaN, and how many were beyond [-1, 1].
  std::int64_t nan_values() const { return nan_values_; }
  std::int64_t clipped_values() const { return clipped_values_; }

 private:
  float checked(float value);

  Blocks blocks_;
  std::int64_t next_;
  int block_ = -1;  // that is in samples_
  Image samples_;
  std::int64_t nan_values_ = 0;
  std::int64_t clipped_values_ = 0;
};

}  // namespace shadertwin
