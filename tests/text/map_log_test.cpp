#include <gtest/gtest.h>

#include <algorithm>

#include "host/text/load.h"
#include "host/text/map_log.h"
#include "host/text/render.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

// A shader whose compiler log names lines of three files.
class MapLog : public testing::Test {
 protected:
  MapLog() {
    folder_.write("image.glsl", "#include \"lib.glsl\"\n#define A \\\n  1\n" + std::string(empty_image));
    folder_.write("lib.glsl", "int l1;\r\nint l2;\r\n");
    folder_.write("common.glsl", "\xEF\xBB\xBFint c1;\r\nint c2;\r\n");
    project_ = load_project(folder_.path(), {.settings = {.defines = {{"N", "1"}}}});
    head_ = first_body_line(project_.passes[0].source) - 1;
  }

  // `log` with @ for the number of the body's line `line`, from 1.
  std::string mapped(std::string log, int line) const {
    log.replace(log.find('@'), 1, std::to_string(head_ + line));
    std::string text = map_log(project_, project_.passes[0].source, log);
    const std::string prefix = folder_.path().string() + "/";
    if (text.starts_with(prefix)) text.erase(0, prefix.size());
    return text;
  }

  TempFolder folder_;
  Project project_;
  int head_ = 0;
};

TEST_F(MapLog, KnowsEveryDriversForm) {
  EXPECT_EQ(mapped("0:@(5): error: `x' undeclared", 2), "common.glsl:1: error: `x' undeclared");
  EXPECT_EQ(mapped("0:@(5): preprocessor error: syntax", 2), "common.glsl:1: error: syntax");
  EXPECT_EQ(mapped("0:@(5): warning: unused", 2), "common.glsl:1: warning: unused");
  EXPECT_EQ(mapped("0(@) : error C1503: undefined variable \"x\"", 3),
            "common.glsl:2: error: undefined variable \"x\"");
  EXPECT_EQ(mapped("0(@) : warning C7050: \"x\" might be used", 3),
            "common.glsl:2: warning: \"x\" might be used");
  EXPECT_EQ(mapped("ERROR: 0:@: 'x' : undeclared identifier", 4),
            "lib.glsl:1: error: 'x' : undeclared identifier");
  EXPECT_EQ(mapped("WARNING: 0:@: 'x' : bad", 5), "lib.glsl:2: warning: 'x' : bad");
}

TEST_F(MapLog, CountsPhysicalLinesBehindAContinuedOne) {
  EXPECT_EQ(mapped("0:@(1): error: x", 9), "image.glsl:4: error: x");
}

TEST_F(MapLog, NamesTheOptionOfADefine) {
  EXPECT_EQ(mapped("0:@(1): error: x", 1), "-D N=1: error: x");
  const Project refused =
      load_project(folder_.path(), {.settings = {.defines = {{"N", ""}, {"GL_N", "1 2"}, {"GL_M", ""}}}});
  EXPECT_EQ(refused.passes[0].source.refused,
            "-D GL_N=1 2: error: the name 'GL_N' is reserved and can't be defined\n"
            "-D GL_M: error: the name 'GL_M' is reserved and can't be defined");
}

TEST_F(MapLog, KeepsWhatIsAboutTheHost) {
  EXPECT_EQ(mapped("0:@(1): error: x", 0), "0:" + std::to_string(head_) + "(1): error: x");
  const PassSource& source = project_.passes[0].source;
  EXPECT_EQ(map_log(project_, source, "error: linking failed\n\n"), "error: linking failed");
  EXPECT_EQ(map_log(project_, source, ""), "");
}

TEST_F(MapLog, PutsWhatLiesBehindTheEndOnTheLastLine) {
  EXPECT_EQ(mapped("0:@(1): error: unexpected end", 12), "image.glsl:4: error: unexpected end");
}

TEST_F(MapLog, LeavesOutTheOverloadsThatWereNotMeant) {
  const std::string at = "0:" + std::to_string(head_ + 2) + "(1): error: ";
  const std::string log = at + "no matching function for call to `f(int)'; candidates are:\n" + at +
                          "   vec4 texture(sampler1D, float)\n" + at + "   float f(float)\n" + at + "x\n";
  const std::string text = map_log(project_, project_.passes[0].source, log);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_NE(text.find("call to `f(int)'\n"), std::string::npos);
}

TEST_F(MapLog, MapsLineByLine) {
  const PassSource& source = project_.passes[0].source;
  const std::string at = std::to_string(head_ + 2);
  const std::string text =
      map_log(project_, source, "0:" + at + "(1): error: a\nnote\n0:" + at + "(1): error: b\n");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_NE(text.find("\nnote\n"), std::string::npos);
}

}  // namespace
}  // namespace shadertwin
