#include "host/view/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "host/player/keyboard.h"

namespace shadertwin::view {
namespace {

TEST(Keys, EveryActionHasOneKeyOfItsOwn) {
  std::set<std::pair<int, int>> keys;
  std::set<Action> actions;
  for (const Binding& binding : bindings()) {
    EXPECT_TRUE(keys.insert({binding.key, binding.modifiers}).second) << binding.name;
    EXPECT_TRUE(actions.insert(binding.action).second) << binding.name;
    EXPECT_EQ(action_for(binding.key, binding.modifiers), binding.action) << binding.name;
  }
  EXPECT_EQ(actions.size(), static_cast<std::size_t>(Action::quit) + 1);
}

TEST(Keys, TheReadmeListsThem) {
  std::ifstream stream(SHADERTWIN_SOURCE_DIR "/README.md");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::string table =
      text.substr(text.find("### The window"), text.find("### Shaders") - text.find("### The window"));
  for (const Binding& binding : bindings()) {
    const std::string name = binding.name;
    EXPECT_TRUE(table.find("| " + name + " |") != std::string::npos ||
                table.find("| " + name + ",") != std::string::npos ||
                table.find(", " + name + " |") != std::string::npos)
        << name;
  }
}

TEST(Keys, LettersDigitsAndArrowsAreTheShaders) {
  for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) EXPECT_FALSE(action_for(key, 0).has_value());
  for (const int key :
       {GLFW_KEY_SPACE, GLFW_KEY_ENTER, GLFW_KEY_ESCAPE, GLFW_KEY_LEFT, GLFW_KEY_UP, GLFW_KEY_0})
    EXPECT_FALSE(action_for(key, 0).has_value());
}

TEST(Keys, LocksDoNotCountAsModifiers) {
  EXPECT_EQ(action_for(GLFW_KEY_F1, GLFW_MOD_CAPS_LOCK | GLFW_MOD_NUM_LOCK), Action::help);
  EXPECT_EQ(action_for(GLFW_KEY_F1, GLFW_MOD_ALT), std::nullopt);
}

TEST(Keys, CodesAreTheBrowsers) {
  EXPECT_EQ(browser_code(GLFW_KEY_SPACE), key_code("space"));
  EXPECT_EQ(browser_code(GLFW_KEY_A), key_code("a"));
  EXPECT_EQ(browser_code(GLFW_KEY_9), key_code("9"));
  EXPECT_EQ(browser_code(GLFW_KEY_F12), key_code("f12"));
  EXPECT_EQ(browser_code(GLFW_KEY_LEFT), key_code("left"));
  EXPECT_EQ(browser_code(GLFW_KEY_DOWN), key_code("down"));
  EXPECT_EQ(browser_code(GLFW_KEY_PAGE_DOWN), key_code("pagedown"));
  EXPECT_EQ(browser_code(GLFW_KEY_RIGHT_CONTROL), key_code("ctrl"));
  EXPECT_EQ(browser_code(GLFW_KEY_DELETE), key_code("delete"));
  // Names that the extension gives: Key_Numpad5, Key_SemiColon, Key_SingleQuote.
  EXPECT_EQ(browser_code(GLFW_KEY_KP_5), 101);
  EXPECT_EQ(browser_code(GLFW_KEY_SEMICOLON), 186);
  EXPECT_EQ(browser_code(GLFW_KEY_APOSTROPHE), 222);
  EXPECT_EQ(browser_code(GLFW_KEY_UNKNOWN), std::nullopt);
}

}  // namespace
}  // namespace shadertwin::view
