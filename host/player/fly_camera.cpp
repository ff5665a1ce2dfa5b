#include "host/player/fly_camera.h"

#include <glm/gtc/constants.hpp>

namespace shadertwin {

namespace {

constexpr double seconds = 0.1;  // what the extension takes every frame for
constexpr double speed = 1.0;
const double turning_speed = glm::pi<double>() / 24.0;

constexpr int alt = 18;
constexpr int down_arrow = 40;
constexpr int left_arrow = 37;

struct Steer {
  int code;
  int axis;  // 0 to 2: along x, y, z; 3 to 5: about them
  double sign;
};
constexpr std::array<Steer, 12> steers = {{{'D', 0, 1.0},
                                           {'A', 0, -1.0},
                                           {'F', 1, 1.0},
                                           {'R', 1, -1.0},
                                           {'W', 2, 1.0},
                                           {'S', 2, -1.0},
                                           {down_arrow, 3, 1.0},
                                           {38, 3, -1.0},
                                           {39, 4, 1.0},
                                           {left_arrow, 4, -1.0},
                                           {'E', 5, 1.0},
                                           {'Q', 5, -1.0}}};

}  // namespace

void FlyCamera::step(const KeyboardState& keyboard, glm::dvec2 look) {
  const bool looks = look != glm::dvec2(0.0);
  std::array<double, 6> along_and_about{};
  for (const Steer& steer : steers) {
    bool& active = steers_[static_cast<std::size_t>(steer.code)];
    active = keyboard.held(steer.code) && (active || !keyboard.held(alt));
    // The mouse takes the place of these two keys.
    if (looks && (steer.code == down_arrow || steer.code == left_arrow)) continue;
    if (active) along_and_about[static_cast<std::size_t>(steer.axis)] += steer.sign;
  }
  const auto& [x, y, z, pitch, yaw, roll] = along_and_about;
  position_ += rotation_ * (seconds * speed * glm::dvec3(x, y, z));
  const glm::dvec3 turn = seconds * turning_speed * glm::dvec3(pitch - look.y, yaw + look.x, roll);
  rotation_ = rotation_ * glm::normalize(glm::dquat(1.0, turn.x, turn.y, turn.z));
}

glm::mat4 FlyCamera::matrix() const {
  glm::dmat4 matrix = glm::mat4_cast(rotation_);
  matrix[3] = glm::dvec4(position_, 1.0);
  return matrix;
}

}  // namespace shadertwin
