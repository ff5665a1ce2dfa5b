// What a shader's precise text looks like.
#include "host/text/make_precise.h"
#include "host/text/load.h"

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/text/syntax_tree.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

// The body of the precise text, whose first pass has this text.
std::string precise_body(const std::string& text) {
  const ScratchFolder folder;
  const auto file = folder.write("shader.glsl", text);
  const Project project = load_project(file);
  return make_precise(project, project.passes[0].source).body;
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "not found: " << part << "\nin:\n" << text;
}

TEST(MakePrecise, MarksVariablesParametersResultsAndConditions) {
  const std::string text = precise_body(
      "float g = 1.0;\nfloat f(in vec2 a, out float b) {\n  float x = a.x * a.y, y;\n  b = x;\n  for (int i "
      "= 0; x < 2.0; i++) if "
      "(x > b) y = x;\n  return x * b;\n}\nvoid mainImage(out vec4 c, in vec2 p) { float t; c = vec4(f(p, "
      "t)); }\n");
  EXPECT_TRUE(contains(text, "precise float g = 1.0"));
  EXPECT_TRUE(contains(text, "float f ( precise in vec2 a , precise out float b )"));
  EXPECT_TRUE(contains(text, "precise float x = a . x * a . y , y ;"));
  EXPECT_TRUE(contains(text, "for ( precise int i = 0 ; (shadertwin_test = (x < 2.0)) ; i ++ )"));
  EXPECT_TRUE(contains(text, "if ( (shadertwin_test = (x > b)) ) y = x ;"));
  EXPECT_TRUE(contains(text, "return (shadertwin_result = (x * b)) ;"));
}

TEST(MakePrecise, AssignsWhatIsComputedForAFunction) {
  const std::string text = precise_body(
      "float f(float x, out float y) { y = x; return x; }\nvoid mainImage(out vec4 c, in vec2 p) {\n  float "
      "y;\n"
      "  c = vec4(f(p.x * 2.0, y) + f(p.x, y) + f(f(1.0 + y, c.x), y) + sin(p.x * 2.0));\n}\n");
  EXPECT_TRUE(contains(text, "precise float shadertwin_argument_0;"));
  EXPECT_TRUE(contains(text,
                       "f ( (shadertwin_argument_0 = (p . x * 2.0)) , y ) + f ( p . x , y ) + "
                       "f ( f ( (shadertwin_argument_1 = (1.0 + y)) , c . x ) , y ) + sin ( p . x * 2.0 )"));
}

TEST(MakePrecise, LinesStayWhereTheyWere) {
  const std::string text =
      precise_body("#define K 2.0\n\nvoid mainImage(out vec4 c, in vec2 p) {\n  c =\n    vec4(K);\n}\n");
  EXPECT_EQ(text.rfind("\n\nvoid mainImage", 0), 0U) << text;
  EXPECT_TRUE(contains(text, "\nvec4 ( 2.0 ) ;\n}\n"));
}

TEST(MakePrecise, NamesThatTheNewerVersionClaimsCompile) {
  const ScratchFolder folder;
  const Project project = load_project(folder.write(
      "shader.glsl",
      "struct S { float fma; };\nfloat bitCount = 1.0;\nfloat fma(float buffer) { return buffer; }\n"
      "void mainImage(out vec4 c, in vec2 p) {\n  float shared = 1.0, precise = 2.0, ldexp = 3.0;\n"
      "  c = vec4(S(fma(shared)).fma, precise, ldexp, bitCount);\n}\n"));
  const PassSource precise = make_precise(project, project.passes[0].source);
  EXPECT_NO_THROW(SyntaxTree(project, precise, Folding::float32)) << precise.body;
}

TEST(MakePrecise, StructuresCanBeReturned) {
  EXPECT_TRUE(contains(
      precise_body(
          "struct S { float x; };\nS f(float a) { return S(a * 2.0); }\nvoid mainImage(out vec4 c, in "
          "vec2 p) { c = vec4(f(p.x).x); }\n"),
      "precise S shadertwin_result; return (shadertwin_result = (S ( a * 2.0 ))) ;"));
}

TEST(MakePrecise, RefusesWhatDoesNotCompile) {
  const ScratchFolder folder;
  const auto file = folder.write("shader.glsl", "void mainImage(out vec4 c, in vec2 p) {\n  c = 1;\n}\n");
  const Project project = load_project(file);
  EXPECT_THROW(make_precise(project, project.passes[0].source), Error);
}

}  // namespace
}  // namespace shadertwin
