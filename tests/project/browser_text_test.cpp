#include "host/project/browser_text.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

TEST(BrowserText, RenamesWordsOfLaterVersions) {
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
            "void f(out vec3 a, inout vec2 b, out lowp int c)\n{ a = vec3(0); c = int(0);");
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

TEST(BrowserText, LetsTheHostSetTheColourThatAMacroDeclares) {
  EXPECT_EQ(as_in_a_browser("#define M void mainImage(out vec4 O, vec2 u)\nM {", true),
            "#define M void mainImage(inout vec4 O, vec2 u)\nM {");
}

}  // namespace
}  // namespace shadertwin
