#include "host/project/browser_text.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

TEST(BrowserText, RenamesWordsOfLaterVersions) {
  EXPECT_EQ(as_in_a_browser("struct uint32_t { int x; };", true), "struct shadertwin_uint32_t { int x; };");
  EXPECT_EQ(as_in_a_browser("float buffer, shared; // buffer\nbuffers.x = packed;", true),
            "float shadertwin_buffer, shadertwin_shared; // buffer\nbuffers.x = shadertwin_packed;");
}

TEST(BrowserText, RenamesOnlyOthersBuiltinsThatTheShaderDefines) {
  EXPECT_EQ(as_in_a_browser("float fma(float a) { return fma(a); }", true),
            "float shadertwin_fma(float a) { return shadertwin_fma(a); }");
  EXPECT_EQ(as_in_a_browser("float f() { return fma(1., 2., 3.); }", true),
            "float f() { return fma(1., 2., 3.); }");
  EXPECT_EQ(as_in_a_browser("float f() { if (b) return bitCount(1); }", true),
            "float f() { if (b) return bitCount(1); }");
}

TEST(BrowserText, NamesParametersWithoutOne) {
  EXPECT_EQ(as_in_a_browser("float f(vec2, in float[3], float[2] x, T) {}", true),
            "float f(vec2 shadertwin_unnamed_0, in float[3] shadertwin_unnamed_1, float[2] x, T "
            "shadertwin_unnamed_2) {}");
  EXPECT_EQ(as_in_a_browser("float f(vec2); float g(void) {} float h() {}", true),
            "float f(vec2); float g(void) {} float h() {}");
  EXPECT_EQ(as_in_a_browser("#define f(a) f(vec2 a)\nfloat f(p) {}", true),
            "#define f(a) f(vec2 a)\nfloat f(p) {}");
  EXPECT_EQ(as_in_a_browser("#define P vec2 p\nfloat f(P) {}", true), "#define P vec2 p\nfloat f(P) {}");
}

TEST(BrowserText, DropsWhatFollowsADirective) {
  EXPECT_EQ(as_in_a_browser("#ifdef A B\n#else A // c\n#endif A\n", true),
            "#ifdef A \n#else  // c\n#endif \n");
  EXPECT_EQ(as_in_a_browser("#ifdef A\n#endif buffer\nint x;\n", true), "#ifdef A\n#endif \nint x;\n");
  EXPECT_EQ(as_in_a_browser("#if A > 1\n#elif B\n#endif\n#endif", true),
            "#if A > 1\n#elif B\n#endif\n#endif");
}

TEST(BrowserText, DropsAHashInAMacro) {
  EXPECT_EQ(as_in_a_browser("#define S(x) #x\n#define P(a, b) a##b\n", true),
            "#define S(x) x\n#define P(a, b) a##b\n");
}

TEST(BrowserText, ZeroesOutputsWhereTheirFunctionStarts) {
  EXPECT_EQ(as_in_a_browser("void f(out vec3 a, inout vec2 b, out lowp int c)\n{", true),
            "void f(out vec3 a, inout vec2 b, out  int c)\n{ a = vec3(0); c = int(0);");
  EXPECT_EQ(as_in_a_browser("void f(out T a, out float b[2], out float[2] c) {", true),
            "void f(out T a, out float b[2], out float[2] c) {");
  EXPECT_EQ(as_in_a_browser("void f(out vec3 a) {", false), "void f(out vec3 a) {");
}

TEST(BrowserText, LeavesWhatThePreprocessorChoosesAlone) {
  const std::string text = "#if A\nvoid f(out vec3 a)\n#else\nvoid f(out vec3 b)\n#endif\n{";
  EXPECT_EQ(as_in_a_browser(text, true), text);
  const std::string parameters = "void f(out vec3 a\n#if A\n, out vec3 b\n#endif\n) {";
  EXPECT_EQ(as_in_a_browser(parameters, true), parameters);
}

TEST(BrowserText, DropsPrecisions) {
  EXPECT_EQ(as_in_a_browser("precision highp int;\nlowp vec2 f(mediump float x);", true),
            "  \n vec2 f( float x);");
  EXPECT_EQ(as_in_a_browser("precision  sampler2DArray;", true), "precision  sampler2DArray;");
  EXPECT_EQ(as_in_a_browser("#define P precision highp int;\n", true), "#define P precision highp int;\n");
}

TEST(BrowserText, DropsQuotesAndOddSpaces) {
  EXPECT_EQ(as_in_a_browser("#if 0\ndon't \"\n'a \"b'\n#endif\f\v", true),
            "#if 0\ndon t  \n a  b \n#endif  ");
}

TEST(BrowserText, RenamesGlobalVariablesNamedAsBuiltins) {
  EXPECT_EQ(as_in_a_browser("float a = step(1., 2.), step = .1;\nvoid f() { a = step; t.step(0); }", true),
            "float a = step(1., 2.), shadertwin_step = .1;\nvoid f() { a = shadertwin_step; t.step(0); }");
  EXPECT_EQ(as_in_a_browser("void f(float step) { float mix = step; }", true),
            "void f(float step) { float mix = step; }");
}

TEST(BrowserText, RenamesOverloadsOfOpenBuiltinsAndForwardsTheOthers) {
  const std::string text = as_in_a_browser(
      "float mix(float a, in float b, float t) { return a; }\nvoid f() { mix(a, b, c); }", true);
  EXPECT_EQ(text.find("float shadertwin_mix(float a, float b, float c)"), std::string::npos) << text;
  EXPECT_NE(text.find("vec2 shadertwin_mix(vec2 a, vec2 b, float c) { return mix(a, b, c); } "),
            std::string::npos);
  EXPECT_NE(text.find("float shadertwin_mix(float a, in float b, float t) { return a; }\nvoid f() { "
                      "shadertwin_mix(a, b, c); }"),
            std::string::npos)
      << text;
}

TEST(BrowserText, GivesTheLastLabelAStatement) {
  EXPECT_EQ(as_in_a_browser("switch (k) { case 1: ; case 2: ; }", true),
            "switch (k) { case 1: ; case 2: break; ; }");
  EXPECT_EQ(as_in_a_browser("switch (k) { case 1: {} default: { {;} } }", true),
            "switch (k) { case 1: {} default: break; { {;} } }");
}

TEST(BrowserText, RenamesMembersCalledLength) {
  EXPECT_EQ(
      as_in_a_browser(
          "struct S { float length, x; };\nfloat f(S s) { return s.length + length(s.x) + a.length(); }",
          true),
      "struct S { float shadertwin_length, x; };\nfloat f(S s) { return s.shadertwin_length + length(s.x) + "
      "a.length(); }");
}

TEST(BrowserText, GivesMacrosOfOneParameterSomethingEmpty) {
  EXPECT_EQ(as_in_a_browser("#define G(x) x\n#define H() 1\nG() G(1) H()", true),
            "#define G(x) x\n#define H() 1\nG(shadertwin_nothing) G(1) H()");
}

TEST(BrowserText, LetsTheHostSetTheColourThatAMacroDeclares) {
  EXPECT_EQ(as_in_a_browser("#define M void mainImage(out vec4 O, vec2 u)\nM {", true),
            "#define M void mainImage(inout vec4 O, vec2 u)\nM {");
}

}  // namespace
}  // namespace shadertwin
