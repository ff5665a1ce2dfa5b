// Texts that the window gives to be typed elsewhere.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/player/fixed_clock.h"
#include "host/player/frame.h"
#include "host/project/project.h"

namespace shadertwin::view {

using UniformValue = std::array<float, 4>;

// Values of #iUniforms as options: `-D speed=2.5 -D 'tint=vec3(0.25, 0.5, 0.75)'`. The numbers read back bit
// for bit. Matrices, which have no editor, are left out.
std::string uniforms_as_options(const std::vector<CustomUniform>& uniforms,
                                const std::vector<UniformValue>& values);

// What draws `frame` again without a window, and the commands that look into one pixel of it.
struct FrameCommand {
  std::string shader;
  std::string options;            // as the user gave them: -D and the like
  double fps = 0.0;               // the clock's fixed rate; 0: real time
  double t0 = 0.0;                // iTime of frame 0
  std::optional<Date> date = {};  // of frame 0; not given: the wall clock's
};
// `pass` is empty for the project's picture. One command a line.
std::string commands_for_pixel(const FrameCommand& command, const Frame& frame, const std::string& pass,
                               glm::ivec2 pixel);

// An argument as a shell takes it: in quotes if it needs them.
std::string quoted(const std::string& argument);

}  // namespace shadertwin::view
