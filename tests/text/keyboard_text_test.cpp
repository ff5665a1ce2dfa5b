#include "host/text/keyboard_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace shadertwin {
namespace {

bool has(const std::string& name, int code) {
  return keyboard_text().find("const int Key_" + name + " = " + std::to_string(code) + ";\n") !=
         std::string::npos;
}

TEST(KeyboardText, HasTheExtensionsNamesAndCodes) {
  EXPECT_TRUE(has("Backspace", 8));
  EXPECT_TRUE(has("Escape", 27));
  EXPECT_TRUE(has("LeftArrow", 37));
  EXPECT_TRUE(has("0", 48));
  EXPECT_TRUE(has("9", 57));
  EXPECT_TRUE(has("A", 65));
  EXPECT_TRUE(has("Z", 90));
  EXPECT_TRUE(has("RightWindows", 92)) << "its own spelling";
  EXPECT_TRUE(has("Numpad9", 105));
  EXPECT_TRUE(has("F1", 112));
  EXPECT_TRUE(has("F12", 123));
  EXPECT_TRUE(has("CloseBraket", 221)) << "its own spelling";
  EXPECT_TRUE(has("SingleQuote", 222));
  const std::string text = keyboard_text();
  EXPECT_EQ(text.find("Key_Space"), std::string::npos);
  // 40 by name, 10 digits twice, 26 letters and 12 function keys; then the four functions.
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 40 + 20 + 26 + 12 + 4);
}

}  // namespace
}  // namespace shadertwin
