// What the C++ of a shader looks like, and which shaders are refused.
#include "reference/emit/emit_cpp.h"
#include "host/text/load.h"

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/emit/emitted.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

std::string refusal(const std::string& shader) {
  const ScratchFolder folder;
  const auto file = folder.write("shader.glsl", shader);
  const Project project = load_project(file);
  try {
    emit_cpp(project, project.passes.back());
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::shader);
    const std::string text = error.what();
    return text.substr(text.find("shader.glsl"));
  }
  return "no error";
}

TEST(EmitCpp, FunctionsKeepTheirNamesAndShape) {
  EXPECT_TRUE(contains(emitted("vec3 shade(vec3 n, float k) { return n.zyx * k + vec3(0.5); }"),
                       "vec3 shade(vec3 n, Float k) {\nreturn n.zyx() * k + vec3(0.5f);\n}\n"));
}

TEST(EmitCpp, EveryStatementNamesTheUsersLine) {
  const std::string text = emitted("float f(float x) {\n  float y = x;\n\n\n  return y;\n}");
  const std::size_t first = text.find("#line 1 ");
  ASSERT_NE(first, std::string::npos) << text;
  const std::string shown = text.substr(text.find('\n', first) + 1);
  EXPECT_EQ(shown.rfind("  Float f(Float x) {\n    Float y = x;\n#line 5 ", 0), 0U) << text;
}

// A name that ends its line or its quotes could hold directives of its own.
TEST(EmitCpp, NamesOfFilesStayInsideTheirQuotes) {
  const ScratchFolder folder;
  Project project = load_project(
      folder.write("shader.glsl", "void mainImage(out vec4 c, in vec2 p) {\n  c = p.xyxy;\n}\n"));
  project.files[0] =
      "a\n#error planted\r\n\"\\\t\x01?"
      "?/.glsl";
  const std::string text = emit_cpp(project, project.passes.back());
  EXPECT_EQ(text.find("\n#error"), std::string::npos);
  EXPECT_NE(text.find("#line 2 \"a\\012\\043error planted\\015\\012\\042\\134\\011\\001\\077\\077/.glsl\"\n"),
            std::string::npos)
      << text;
}

TEST(EmitCpp, ConstructorAsAStatementDeclaresNothing) {
  const std::string text =
      emitted("float f(float a) { vec2(a); for (; a < 2.0; vec3(a), a++) {} return a; }");
  EXPECT_TRUE(contains(text, "(void)vec2(a);\n")) << text;
  EXPECT_TRUE(contains(text, "(void)vec3(a), ")) << text;
}

TEST(EmitCpp, VariableThatOutlivesARoundIsDeclaredBeforeTheLoop) {
  EXPECT_TRUE(
      contains(emitted("float f() { float s = 0.0, last; for (int i = 0; i < 3; i++) { if (i > 0) s += last; "
                       "last = float(i); } return s; }"),
               "Float last;\nfor (int i = 0; i < 3; i++) {\n"));
}

TEST(EmitCpp, VariableOfALoopBodyIsFreshInEveryRound) {
  EXPECT_TRUE(contains(
      emitted("float f() { float s = 0.0; for (int i = 0; i < 3; i++) { float x; if (i == 1) x = 2.0; "
              "s += x; } return s; }"),
      "for (int i = 0; i < 3; i++) {\nFloat x;\n"));
}

TEST(EmitCpp, ConstantsKeepTheirNames) {
  const std::string text = emitted(
      "const float PI = 3.25; const float list[2] = float[](1.0, 2.0); const float two_pi = "
      "2.0 * PI;\nfloat f(int i) { return PI * 3.0 + list[i] + two_pi; }");
  EXPECT_TRUE(contains(text, "const array<Float, 2> list = array<Float, 2>{{1.0f, 2.0f}};\n"));
  EXPECT_TRUE(contains(text, "const Float two_pi = 6.5f;\n"));
  EXPECT_TRUE(contains(text, "return 9.75f + list[i] + two_pi;\n"));
}

TEST(EmitCpp, ConstantsAreFoldedInFloatAsAGpuCompilerDoes) {
  const std::string shader = "float f(float x) { return x + (0.1 + 0.6); }";
  EXPECT_TRUE(contains(emitted(shader), "return x + 0.70000005f;\n"));
  CppOptions wide;
  wide.double_precision = true;
  EXPECT_TRUE(contains(emitted(shader, wide), "return x + 0.7;\n"));
}

TEST(EmitCpp, DrawsStayInOrder) {
  EXPECT_TRUE(
      contains(emitted("float s = 1.0;\nfloat r() { s *= 2.0; return s; }\nfloat f() { return r() - r(); }"),
               "const Float tmp = r();\nreturn tmp - r();\n"));
}

TEST(EmitCpp, ArgumentsWithoutSideEffectsStayInPlace) {
  EXPECT_TRUE(contains(
      emitted("float g(float x) { return x * 2.0; }\nfloat f(float a) { return g(a) - g(a + 1.0); }"),
      "return g(a) - g(a + 1.0f);\n"));
}

TEST(EmitCpp, InoutSwizzleIsCopiedInAndOut) {
  EXPECT_TRUE(contains(emitted("void g(inout vec2 v) { v += 1.0; }\nvec3 f(vec3 a) { g(a.zx); return a; }"),
                       "vec2 tmp = a.zx();\ng(tmp);\nswizzle<2, 0>(a) = tmp;\n"));
}

TEST(EmitCpp, GlobalIsCopiedWhereTheFunctionCanReachItItself) {
  EXPECT_TRUE(contains(emitted("float s = 1.0;\nvoid g(inout float v) { v += s; }\nvoid f() { g(s); }"),
                       "Float tmp = s;\ng(tmp);\ns = tmp;\n"));
}

TEST(EmitCpp, InoutIsReadBehindTheEffectsOfOtherArguments) {
  EXPECT_TRUE(contains(emitted("int n;\nint next() { return ++n; }\nvoid g(int d, inout int v) { v += d; }\n"
                               "void f() { g(next(), n); }"),
                       "const int tmp = next();\nint tmp_2 = n;\ng(tmp, tmp_2);\nn = tmp_2;\n"));
}

TEST(EmitCpp, IndexWithAnEffectIsEvaluatedOnce) {
  EXPECT_TRUE(contains(emitted("float f() { float a[3]; int i = 0; a[i++] *= 2.0; return a[0]; }"),
                       "const int tmp = i++;\na[tmp] *= 2.0f;\n"));
}

TEST(EmitCpp, IndexedSwizzleIsAComponentOfItsVector) {
  EXPECT_TRUE(contains(emitted("vec4 f(vec4 v, int i) { v.zyx[i] = 7.0; return v; }"),
                       "at(v, at(ivec3(2, 1, 0), i)) = 7.0f;\n"));
}

TEST(EmitCpp, LengthKeepsTheCallThatGivesTheArray) {
  EXPECT_TRUE(contains(emitted("int n;\nfloat[3] g() { n++; return float[3](1.0, 2.0, 3.0); }\n"
                               "int f() { return g().length(); }"),
                       "g();\nreturn 3;\n"));
}

TEST(EmitCpp, OutParameterDoesNotKeepTheCallersValue) {
  EXPECT_TRUE(contains(emitted("void g(out vec2 v, float x) { if (x > 0.0) v.x = x; }"), "unwritten(v);\n"));
}

TEST(EmitCpp, WordsOfCppAreRenamed) {
  EXPECT_TRUE(contains(emitted("float delete(float new) { return new; }"),
                       "Float delete_(Float new_) {\nreturn new_;\n"));
}

TEST(EmitCpp, NamesThatDifferByUnderscoresStayApart) {
  EXPECT_TRUE(contains(emitted("float f(float new, float new_, float set__, float a_) { return new + new_ + "
                               "set__ + a_; }"),
                       "return new_ + new__ + set___ + a_;\n"));
}

TEST(EmitCpp, MemberNamedAfterItsTypeIsRenamed) {
  EXPECT_TRUE(contains(
      emitted("struct ray { vec3 d; };\nstruct hit { ray ray; };\nvec3 f(hit h) { return h.ray.d; }"),
      "ray ray_2;\n"));
}

TEST(EmitCpp, MacrosOfHeadersAreUndefined) {
  EXPECT_TRUE(contains(emitted("float f(float alloca) { return alloca; }"), "#undef alloca\n"));
}

TEST(EmitCpp, LocalNamedAfterABuiltinThatTheFunctionCallsIsRenamed) {
  EXPECT_TRUE(contains(emitted("float f(vec2 p) { float length = length(p); return length; }"),
                       "Float length_2 = length(p);\nreturn length_2;\n"));
}

TEST(EmitCpp, RefusalNamesTheUsersLine) {
  EXPECT_EQ(refusal("void mainImage(out vec4 c, in vec2 p) {\n\n  c = vec3(1.0);\n}\n")
                .rfind("shader.glsl:3: error: ", 0),
            0U);
  EXPECT_EQ(refusal("#define WRONG nonsense\n\nvoid mainImage(out vec4 c, in vec2 p) {\n  c = vec4(p,\n  "
                    "WRONG, 1.0);\n}\n")
                .rfind("shader.glsl:5: error: 'nonsense'", 0),
            0U);
}

TEST(EmitCpp, RecursionIsRefused) {
  EXPECT_EQ(
      refusal(
          "float g(float x);\nfloat f(float x) {\n  return g(x);\n}\nfloat g(float x) { return f(x); }\nvoid "
          "mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x)); }\n"),
      "shader.glsl:5: error: 'f' calls itself: recursion is not allowed");
}

TEST(EmitCpp, FunctionWithoutDefinitionIsRefused) {
  EXPECT_EQ(refusal("float f(float x);\nvoid mainImage(out vec4 c, in vec2 p) {\n  c = vec4(f(p.x));\n}\n"),
            "shader.glsl:3: error: 'f' is called but not defined");
}

}  // namespace
}  // namespace shadertwin
