// iMouse as its host computes it from what a hand does.
#pragma once

#include <glm/glm.hpp>

#include "host/project/host_rules.h"

namespace shadertwin {

// Positions are window pixels with y up; by the site's rules they are floored and kept inside the picture.
// Events come in between frames; next_frame() gives the value that one frame sees.
class Mouse {
 public:
  explicit Mouse(const HostRules& rules)
      : rules_(rules), position_(rules.first_mouse), pressed_at_(0.0F - rules.first_mouse) {}

  void press(glm::dvec2 position, glm::ivec2 size);
  void move(glm::dvec2 position, glm::ivec2 size);  // counts only while a button is down
  void release();
  bool down() const { return down_; }
  // Where a held mouse has been dragged to, from the picture's centre (0, 0) to its corners (-1, -1) and (1,
  // 1); zero until it moves, and when it is let go.
  glm::dvec2 look() const { return look_; }

  // xy: where the mouse was last dragged to. zw: where it was pressed; z is positive while it is down, and w
  // is positive only on the first frame after the press (also when the release came before that frame).
  glm::vec4 next_frame();

 private:
  HostRules rules_;
  glm::vec2 position_;
  glm::vec2 pressed_at_;  // shown negative while no button is down
  glm::dvec2 look_{0.0};
  bool down_ = false;
  bool pressed_ = false;   // since the last frame
  bool released_ = false;  // likewise, if it was seen pressed
};

}  // namespace shadertwin
