// iMouse as shadertoy.com computes it from what a hand does.
#pragma once

#include <glm/glm.hpp>

namespace shadertwin {

// Positions are window pixels with y up; they are floored and kept inside the picture. Events come in between
// frames; next_frame() gives the value that one frame sees.
class Mouse {
 public:
  // vscode_quirks: as the extension "Shader Toy" computes it, not the site: nothing is floored or clamped,
  // all is -1 at first, and w is positive also on the first frame after the release.
  explicit Mouse(bool vscode_quirks = false) : quirks_(vscode_quirks) {
    if (!quirks_) return;
    position_ = glm::vec2(-1.0F);
    pressed_at_ = glm::vec2(1.0F);  // shown as -1
  }

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
  glm::vec2 position_{0.0F};
  glm::vec2 pressed_at_{0.0F};
  glm::dvec2 look_{0.0};
  bool quirks_;
  bool down_ = false;
  bool pressed_ = false;   // since the last frame
  bool released_ = false;  // likewise, if it was seen pressed
};

}  // namespace shadertwin
