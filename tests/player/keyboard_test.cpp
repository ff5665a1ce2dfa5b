#include "host/player/keyboard.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

// Held, pressed, toggled, released of one key, as 0 or 1.
std::array<int, 4> rows_of(const KeyboardState& keyboard, int code) {
  std::array<int, 4> rows{};
  for (std::size_t row = 0; row < 4; ++row)
    rows[row] = keyboard.rows()[row * 256 + static_cast<std::size_t>(code)] == 255 ? 1 : 0;
  return rows;
}

using Rows = std::array<int, 4>;

TEST(Keyboard, ShowsAPressForOneFrameAndTogglesOnEveryPress) {
  KeyboardState keyboard(host_rules(Dialect::shadertoy));
  keyboard.press(65);
  EXPECT_EQ(rows_of(keyboard, 65), (Rows{1, 1, 1, 0}));
  keyboard.end_frame();
  EXPECT_EQ(rows_of(keyboard, 65), (Rows{1, 0, 1, 0}));
  keyboard.release(65);
  keyboard.end_frame();
  EXPECT_EQ(rows_of(keyboard, 65), (Rows{0, 0, 1, 0}));
  keyboard.press(65);
  EXPECT_EQ(rows_of(keyboard, 65), (Rows{1, 1, 0, 0}));
}

TEST(Keyboard, IgnoresAutoRepeat) {
  KeyboardState keyboard(host_rules(Dialect::shadertoy));
  keyboard.press(65);
  keyboard.end_frame();
  keyboard.press(65);
  EXPECT_EQ(rows_of(keyboard, 65), (Rows{1, 0, 1, 0}));
}

TEST(Keyboard, TapBetweenFramesShowsOnlyInTheToggleRowOnTheSite) {
  KeyboardState site(host_rules(Dialect::shadertoy));
  site.press(32);
  site.release(32);
  EXPECT_EQ(rows_of(site, 32), (Rows{0, 0, 1, 1}));
  KeyboardState extension(host_rules(Dialect::vscode));
  extension.press(32);
  extension.release(32);
  EXPECT_EQ(rows_of(extension, 32), (Rows{0, 1, 1, 1}));
}

TEST(Keyboard, IgnoresCodesItHasNoColumnFor) {
  KeyboardState keyboard(host_rules(Dialect::shadertoy));
  keyboard.press(-1);
  keyboard.press(256);
  keyboard.release(65);
  EXPECT_EQ(keyboard.rows(), KeyboardState::Rows{});
}

TEST(KeyCode, KnowsNamesLettersDigitsFunctionKeysAndNumbers) {
  EXPECT_EQ(key_code("space"), 32);
  EXPECT_EQ(key_code("Left"), 37);
  EXPECT_EQ(key_code("a"), 65);
  EXPECT_EQ(key_code("Z"), 90);
  EXPECT_EQ(key_code("7"), 55);
  EXPECT_EQ(key_code("f1"), 112);
  EXPECT_EQ(key_code("F12"), 123);
  EXPECT_EQ(key_code("186"), 186);
  EXPECT_EQ(key_code("f13"), std::nullopt);
  EXPECT_EQ(key_code("256"), std::nullopt);
  EXPECT_EQ(key_code("nonsense"), std::nullopt);
  EXPECT_EQ(key_code(""), std::nullopt);
}

}  // namespace
}  // namespace shadertwin
