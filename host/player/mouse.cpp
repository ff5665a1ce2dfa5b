#include "host/player/mouse.h"

namespace shadertwin {

namespace {

// x in [0, width - 1] and y in [1, height]: the top row gives the height (the page measures y from the top).
glm::vec2 to_pixel(glm::dvec2 position, glm::ivec2 size) {
  return glm::clamp(glm::floor(position), glm::dvec2(0.0, 1.0), glm::dvec2(size.x - 1, size.y));
}

}  // namespace

void Mouse::press(glm::dvec2 position, glm::ivec2 size) {
  position_ = pressed_at_ = rules_.keeps_mouse_fractions ? glm::vec2(position) : to_pixel(position, size);
  released_ = false;
  look_ = glm::dvec2(0.0);
  down_ = pressed_ = true;
}

void Mouse::move(glm::dvec2 position, glm::ivec2 size) {
  if (!down_) return;
  position_ = rules_.keeps_mouse_fractions ? glm::vec2(position) : to_pixel(position, size);
  look_ = 2.0 * position / glm::dvec2(size) - 1.0;
}

void Mouse::release() {
  released_ = down_ && !pressed_;
  down_ = false;
  if (rules_.mouse_release_counts) pressed_ = false;
  look_ = glm::dvec2(0.0);
}

glm::vec4 Mouse::next_frame() {
  const glm::vec4 value(
      position_, down_ ? pressed_at_.x : -pressed_at_.x,
      pressed_ || (rules_.mouse_release_counts && released_) ? pressed_at_.y : -pressed_at_.y);
  pressed_ = released_ = false;
  return value;
}

}  // namespace shadertwin
