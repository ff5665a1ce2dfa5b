#include "host/player/mouse.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shadertwin {
namespace {

constexpr glm::ivec2 window(640, 360);

TEST(Mouse, IsNegativeZeroBeforeTheFirstClick) {
  Mouse mouse(host_rules(Dialect::shadertoy));
  mouse.move({100.0, 50.0}, window);  // hovering is not tracked
  const glm::vec4 value = mouse.next_frame();
  EXPECT_EQ(value, glm::vec4(0.0F));
  EXPECT_TRUE(std::signbit(value.z));
  EXPECT_TRUE(std::signbit(value.w));
}

TEST(Mouse, HasTheExtensionsQuirksWhenAsked) {
  Mouse mouse(host_rules(Dialect::vscode, true));
  EXPECT_EQ(mouse.next_frame(), glm::vec4(-1.0F));
  mouse.press({100.5, 50.25}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(100.5, 50.25, 100.5, 50.25));
  mouse.move({700.0, -3.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(700, -3, 100.5, -50.25));
  mouse.release();
  EXPECT_EQ(mouse.next_frame(), glm::vec4(700, -3, -100.5, 50.25));
  EXPECT_EQ(mouse.next_frame(), glm::vec4(700, -3, -100.5, -50.25));
  mouse.press({1.0, 2.0}, window);
  mouse.release();
  EXPECT_EQ(mouse.next_frame(), glm::vec4(1, 2, -1, -2));
}

TEST(Mouse, ShowsThePressOnOneFrameAndTheDragUntilTheRelease) {
  Mouse mouse(host_rules(Dialect::shadertoy));
  mouse.press({100.0, 50.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(100, 50, 100, 50));
  EXPECT_EQ(mouse.next_frame(), glm::vec4(100, 50, 100, -50));
  mouse.move({120.0, 70.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(120, 70, 100, -50));
  mouse.release();
  mouse.move({300.0, 300.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(120, 70, -100, -50));
}

TEST(Mouse, ShowsAClickBetweenTwoFramesOnce) {
  Mouse mouse(host_rules(Dialect::shadertoy));
  mouse.press({10.0, 20.0}, window);
  mouse.release();
  EXPECT_EQ(mouse.next_frame(), glm::vec4(10, 20, -10, 20));
  EXPECT_EQ(mouse.next_frame(), glm::vec4(10, 20, -10, -20));
}

TEST(Mouse, FloorsAndStaysInThePicture) {
  Mouse mouse(host_rules(Dialect::shadertoy));
  mouse.press({10.9, 20.9}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(10, 20, 10, 20));
  mouse.move({-5.0, -5.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(0, 1, 10, -20));
  mouse.move({9999.0, 9999.0}, window);
  EXPECT_EQ(mouse.next_frame(), glm::vec4(639, 360, 10, -20));
}

}  // namespace
}  // namespace shadertwin
