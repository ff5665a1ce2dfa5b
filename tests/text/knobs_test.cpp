#include "host/text/knobs.h"

#include <gtest/gtest.h>

#include "host/text/load.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

constexpr const char* stepped_image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(STEPS); }\n";

class Knobs : public testing::Test {
 protected:
  Project load(const std::string& text, const Defines& defines = {}) const {
    return load_project(folder.write("a.glsl", text + stepped_image), {.settings = {.defines = defines}});
  }
  TempFolder folder;
};

TEST_F(Knobs, AreMacrosWithAGuardAndAValue) {
  folder.write("more.glsl",
               "#ifndef MORE_GLSL\n#define MORE_GLSL\n"
               "# ifndef SOFT // shadows\n\n#  define SOFT (1.0 / 3.0) /* of a metre */\n#endif\n#endif\n");
  const std::vector<Knob> knobs = find_knobs(
      load("#include \"more.glsl\"\n#define FIXED 3\n#ifndef STEPS\n#define STEPS 64\n#endif\n#ifndef OTHER\n"
           "#define SOMETHING_ELSE 1\n#endif\n",
           {{"STEPS", "8"}}));
  ASSERT_EQ(knobs.size(), 2U);
  EXPECT_EQ(knobs[0].name, "SOFT");
  EXPECT_EQ(knobs[0].value, "(1.0 / 3.0)");
  EXPECT_EQ(knobs[1].name, "STEPS");
  EXPECT_EQ(knobs[1].value, "64");
}

TEST_F(Knobs, MayDecideConditions) {
  const Project project =
      load("#if STEPS > 3\n#endif\n#ifndef OTHER\n#define OTHER 1\n#endif\nint if_other = OTHER;\n");
  EXPECT_TRUE(decides_conditions(project, "STEPS"));
  EXPECT_FALSE(decides_conditions(project, "OTHER"));
}

TEST_F(Knobs, AreWarnedOfWhenNoPassMentionsThem) {
  const std::string text = "#ifndef STEPS\n#define STEPS 64\n#endif\n#ifdef FAST\n#endif\n";
  EXPECT_TRUE(load(text, {{"STEPS", "8"}, {"FAST", "1"}}).warnings.empty());
  EXPECT_EQ(load(text, {{"STPES", "8"}}).warnings,
            (std::vector<std::string>{"-D STPES: warning: no pass mentions STPES; is STEPS meant?"}));
  EXPECT_EQ(load(text, {{"SCENE", "1"}}).warnings,
            (std::vector<std::string>{"-D SCENE: warning: no pass mentions SCENE"}));
}

}  // namespace
}  // namespace shadertwin
