#include "host/player/fly_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <string>

#include "host/player/fixed_clock.h"
#include "host/player/live_clock.h"
#include "host/player/uniforms.h"

namespace shadertwin {
namespace {

const double step_angle = 2.0 * std::atan(0.1 * glm::pi<double>() / 24.0);

// The camera after `steps` frames with a key held.
glm::mat4 after(const std::string& key, int steps) {
  KeyboardState keyboard(host_rules(Dialect::vscode));
  keyboard.press(key_code(key).value());
  FlyCamera camera;
  for (int i = 0; i < steps; ++i) camera.step(keyboard, {0.0, 0.0});
  return camera.matrix();
}

void expect_close(glm::vec3 value, glm::vec3 expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 1e-6F) << i;
}

TEST(FlyCamera, KeysMoveItATenthAFrameAlongItsAxes) {
  expect_close(after("w", 5)[3], {0, 0, 0.5F});
  expect_close(after("s", 5)[3], {0, 0, -0.5F});
  expect_close(after("d", 5)[3], {0.5F, 0, 0});
  expect_close(after("a", 5)[3], {-0.5F, 0, 0});
  expect_close(after("r", 5)[3], {0, -0.5F, 0});
  expect_close(after("f", 5)[3], {0, 0.5F, 0});
}

TEST(FlyCamera, ArrowsAndQAndETurnItByTheExtensionsStep) {
  const float s = static_cast<float>(std::sin(10.0 * step_angle));
  const float c = static_cast<float>(std::cos(10.0 * step_angle));
  expect_close(after("right", 10)[2], {s, 0, c});
  expect_close(after("left", 10)[2], {-s, 0, c});
  expect_close(after("down", 10)[2], {0, -s, c});
  expect_close(after("up", 10)[2], {0, s, c});
  expect_close(after("e", 10)[0], {c, s, 0});
  expect_close(after("q", 10)[0], {c, -s, 0});
}

TEST(FlyCamera, GoesWhereItLooks) {
  KeyboardState keyboard(host_rules(Dialect::vscode));
  keyboard.press(39);
  FlyCamera camera;
  for (int i = 0; i < 10; ++i) camera.step(keyboard, {0.0, 0.0});
  keyboard.release(39);
  keyboard.press('W');
  camera.step(keyboard, {0.0, 0.0});
  const glm::mat4 view = camera.matrix();
  expect_close(view[3], 0.1F * glm::vec3(view[2]));
}

TEST(FlyCamera, MouseAtTheEdgeTurnsAsAnArrowAndHalfWayHalfAsFast) {
  FlyCamera by_mouse;
  for (int i = 0; i < 10; ++i) by_mouse.step(KeyboardState(host_rules(Dialect::vscode)), {1.0, 0.0});
  EXPECT_EQ(by_mouse.matrix(), after("right", 10));
  FlyCamera upwards;
  for (int i = 0; i < 10; ++i) upwards.step(KeyboardState(host_rules(Dialect::vscode)), {0.0, 1.0});
  EXPECT_EQ(upwards.matrix(), after("up", 10));
  FlyCamera half;
  half.step(KeyboardState(host_rules(Dialect::vscode)), {0.5, 0.0});
  EXPECT_NEAR(half.matrix()[2].x, std::sin(0.5 * step_angle), 1e-5);
}

TEST(FlyCamera, KeyPressedWithAltDoesNotSteer) {
  KeyboardState keyboard(host_rules(Dialect::vscode));
  keyboard.press(18);
  keyboard.press('W');
  FlyCamera camera;
  camera.step(keyboard, {0.0, 0.0});
  EXPECT_EQ(camera.matrix(), glm::mat4(1.0F));
  keyboard.release('W');
  keyboard.release(18);
  camera.step(keyboard, {0.0, 0.0});
  keyboard.press('W');
  camera.step(keyboard, {0.0, 0.0});
  keyboard.press(18);
  camera.step(keyboard, {0.0, 0.0});
  expect_close(camera.matrix()[3], {0, 0, 0.2F});
}

// What a frame's iViewMatrix is.
glm::mat4 view_of(const Frame& frame, bool controls) {
  Project project;
  project.first_person_controls = controls;
  return uniforms_for(project, Pass(), frame, {64, 36}, ChannelSizes()).iViewMatrix;
}

TEST(FlyCamera, ScheduledKeysFlyFromTheirFrameOn) {
  Schedule schedule;
  schedule.keys = {{1, 'W'}};
  FixedClock clock(schedule, host_rules(Dialect::vscode));
  EXPECT_EQ(view_of(clock.next(), true), glm::mat4(1.0F));
  const Frame frame = clock.next();
  expect_close(view_of(frame, true)[3], {0, 0, 0.1F});
  EXPECT_EQ(view_of(frame, false), glm::mat4(1.0F)) << "only #iFirstPersonControls moves it";
}

TEST(FlyCamera, ScheduledDragTurnsButAPressAloneDoesNot) {
  Schedule schedule;
  schedule.width = 64;
  schedule.height = 36;
  schedule.mouse = {{0, {60, 18}, true}, {2, {64, 18}, true}, {4, {64, 18}, false}};
  FixedClock clock(schedule, host_rules(Dialect::vscode));
  EXPECT_EQ(view_of(clock.next(), true), glm::mat4(1.0F));
  EXPECT_EQ(view_of(clock.next(), true), glm::mat4(1.0F));
  clock.next();
  const glm::mat4 turned = view_of(clock.next(), true);
  EXPECT_EQ(turned, after("right", 2));
  EXPECT_EQ(view_of(clock.next(), true), turned) << "let go";
}

TEST(FlyCamera, LiveCameraRestsWhilePausedAndReturnsOnReset) {
  LiveClock clock({}, host_rules(Dialect::vscode));
  clock.keyboard().press('W');
  ClockReading now;
  expect_close(clock.next(now, {64, 36}).view[3], {0, 0, 0.1F});
  clock.set_paused(true);
  clock.force();
  expect_close(clock.next(now, {64, 36}).view[3], {0, 0, 0.1F});
  clock.set_paused(false);
  expect_close(clock.next(now, {64, 36}).view[3], {0, 0, 0.2F});
  clock.reset();
  expect_close(clock.next(now, {64, 36}).view[3], {0, 0, 0.1F});
}

}  // namespace
}  // namespace shadertwin
