// The values that change from frame to frame, as plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace shadertwin {

struct Frame {
  int width = 640;
  int height = 360;
  int index = 0;             // iFrame
  double time = 0.0;         // iTime, seconds
  double time_delta = 0.0;   // iTimeDelta, seconds
  double frame_rate = 60.0;  // iFrameRate
  glm::vec4 date{0.0F};      // year, month from 0, day from 1, seconds since midnight
  glm::vec4 mouse{0.0F};     // iMouse, as the shader sees it
  glm::vec4 mouse_button{0.0F};
  glm::mat4 view{1.0F};  // iViewMatrix where the project has first person controls
  // One byte a key code (the browser's legacy keyCode), 0 or 255. Rows: held, pressed, toggled, released.
  std::array<std::uint8_t, std::size_t{256} * 4> keyboard{};
  // Values of Project::uniforms, in their order. Empty: those that the project gives.
  std::vector<std::array<float, 4>> uniforms;
};

}  // namespace shadertwin
