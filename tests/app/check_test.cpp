// `shadertwin check` as a user types it: each kind of finding in a planted shader, at its line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

class CheckCommand : public testing::Test {
 protected:
  // What check says about an image shader whose first line is `before` and whose third is `statements`.
  Outcome check(const std::string& before, const std::string& statements, const std::string& options = "") {
    folder.write("a.glsl", before + "\nvoid mainImage(out vec4 c, in vec2 p) {\n" + statements + "\n}\n");
    return run(folder, "check a.glsl --size 8x4 " + options);
  }
  ScratchFolder folder;
};

// The only finding starts with `text`.
void expect_only(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.out.rfind(text, 0), 0U) << outcome.out << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1) << outcome.out;
}

TEST_F(CheckCommand, IsSilentAboutASoundShader) {
  const Outcome outcome = check("float half_of(float x) { return 0.5 * x; }", "c = vec4(half_of(p.x));");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CheckCommand, TellsEveryErrorOfTheLanguageAtItsLine) {
  const Outcome outcome =
      check("float one() { return 1; }", "float a = 1;\nfloat b = a * 2;\nc = vec4(a, b, one(), q);");
  EXPECT_EQ(outcome.status, 1);
  for (const char* line :
       {"a.glsl:1: webgl2: ", "\na.glsl:3: webgl2: ", "\na.glsl:4: webgl2: ", "\na.glsl:5: webgl2: "})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << '\n' << outcome.out;
  EXPECT_EQ(outcome.err, "shadertwin: a.glsl: 4 findings\n");
}

TEST_F(CheckCommand, FindsWhatOnlyBrowsersRefuse) {
  expect_only(check("float my__name = 1.0;", "c = vec4(my__name);"), "a.glsl:1: webgl2: 'my__name'");
  expect_only(check("", "float webgl_x = p.x;\nc = vec4(webgl_x);"), "a.glsl:3: webgl2: 'webgl_x'");
  expect_only(check("float f() { return 1.0; };", "c = vec4(f());"), "a.glsl:1: webgl2: semicolon");
  expect_only(
      check("float f() { return 1.0; }\n#extension GL_OES_standard_derivatives : enable", "c = vec4(f());"),
      "a.glsl:2: webgl2: #extension");
}

TEST_F(CheckCommand, FindsNamesOfOneHostOnly) {
  expect_only(check("", "c = vec4(saturate(p.x));"), "a.glsl:3: portability: 'saturate'");
  expect_only(check("", "c = vec4(iFrameRate);"), "a.glsl:3: portability: 'iFrameRate'");
}

TEST_F(CheckCommand, LeavesTextForLocalHostsAlone) {
  const Outcome outcome = check(
      "#ifdef SHADER_TOY\nfloat f(float x) { return saturate(x); }\n#else\nfloat f(float x) { return x; "
      "}\n#endif",
      "c = vec4(f(p.x));");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, FindsAnOutputThatAReturnLeavesUnwritten) {
  expect_only(
      check(
          "bool hit(float x, out float t) {\n  if (x > 2.0)\n    return false;\n  t = x;\n  return true;\n}",
          "float t = 0.0;\nc = hit(p.x, t) ? vec4(t) : vec4(0);"),
      "a.glsl:3: out: 't' of hit() is not written");
}

TEST_F(CheckCommand, FindsAnOutputThatAFunctionsEndLeavesUnwritten) {
  expect_only(check("void hit(float x, out float t) { if (x > 2.0) t = x; }",
                    "float t = 0.0;\nhit(p.x, t);\nc = vec4(0.0);"),
              "a.glsl:1: out: 't' of hit() is not written");
}

TEST_F(CheckCommand, AcceptsOutputsWrittenOnEveryPath) {
  const Outcome outcome = check(
      "void f(int i, out float t) {\n  switch (i) { case 0: t = 1.0; break; default: t = 2.0; }\n}\n"
      "void g(int i, out float t) {\n  if (i > 3) { f(i, t); return; }\n  for (int k = 0; k < 4; ++k) t = "
      "1.0;\n}",
      "float t; g(int(p.x), t);\nc = vec4(t);");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, WritesItsFindingsAsJson) {
  const Outcome outcome = check("float my__name = 1.0;", "c = vec4(my__name);", "--json r.json");
  EXPECT_EQ(outcome.status, 1);
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  ASSERT_EQ(report["findings"].size(), 1U);
  EXPECT_EQ(report["findings"][0]["file"], "a.glsl");
  EXPECT_EQ(report["findings"][0]["line"], 1);
  EXPECT_EQ(report["findings"][0]["kind"], "webgl2");
}

TEST_F(CheckCommand, KeepsOtherExitStatuses) {
  EXPECT_EQ(run(folder, "check missing.glsl").status, 4);
  EXPECT_EQ(check("", "c = vec4(1.0);", "--frames 0").status, 2);
}

}  // namespace
}  // namespace shadertwin
