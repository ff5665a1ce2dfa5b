// iViewMatrix as #iFirstPersonControls of the extension moves it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "host/player/keyboard.h"

namespace shadertwin {

// W and S move along the camera's own +z and -z, D and A along +x and -x, F and R along +y and -y; the arrows
// turn, Q and E roll, and a dragged mouse turns the faster the further it is from the picture's centre. Every
// frame is one step of the same size, however long it took.
class FlyCamera {
 public:
  // What one frame adds. `look`: Mouse::look().
  void step(const KeyboardState& keyboard, glm::dvec2 look);
  // From camera to world; the identity before the first step.
  glm::mat4 matrix() const;

 private:
  glm::dvec3 position_{0.0};
  glm::dquat rotation_{1.0, 0.0, 0.0, 0.0};
  std::array<bool, 256> steers_{};  // by key code; a key pressed while Alt is held does not count
};

}  // namespace shadertwin
