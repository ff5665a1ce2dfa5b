#include "host/text/canonicalise.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

TEST(Canonicalise, RenamesWordsOfLaterVersions) {
  EXPECT_EQ(canonicalise("struct uint32_t { int x; };"), "struct shadertwin_uint32_t { int x; };");
  EXPECT_EQ(canonicalise("float buffer, shared; // buffer\nbuffers.x = packed;"),
            "float shadertwin_buffer, shadertwin_shared; // buffer\nbuffers.x = shadertwin_packed;");
  EXPECT_EQ(canonicalise("int shadertwin_at; float shadertwin_buffer, buffer;"),
            "int shadertwin_shadertwin_at; float shadertwin_shadertwin_buffer, shadertwin_buffer;");
}

TEST(Canonicalise, RenamesOnlyOthersBuiltinsThatTheShaderDefines) {
  EXPECT_EQ(canonicalise("float fma(float a) { return fma(a); }"),
            "float shadertwin_fma(float a) { return shadertwin_fma(a); }");
  EXPECT_EQ(canonicalise("float f() { return fma(1., 2., 3.); }"), "float f() { return fma(1., 2., 3.); }");
  EXPECT_EQ(canonicalise("float f() { if (b) return bitCount(1); }"),
            "float f() { if (b) return bitCount(1); }");
}

TEST(Canonicalise, NamesParametersWithoutOne) {
  EXPECT_EQ(canonicalise("float f(vec2, in float[3], float[2] x, T) {}"),
            "float f(vec2 shadertwin_unnamed_0, in float[3] shadertwin_unnamed_1, float[2] x, T "
            "shadertwin_unnamed_2) {}");
  EXPECT_EQ(canonicalise("float f(vec2); float g(void) {} float h() {}"),
            "float f(vec2); float g(void) {} float h() {}");
}

TEST(Canonicalise, DropsPrecisions) {
  EXPECT_EQ(canonicalise("precision highp int;\nlowp vec2 f(mediump float x);"), "  \n vec2 f( float x);");
  EXPECT_EQ(canonicalise("precision  sampler2DArray;"), "precision  sampler2DArray;");
}

TEST(Canonicalise, RenamesGlobalVariablesNamedAsBuiltins) {
  EXPECT_EQ(canonicalise("float a = step(1., 2.), step = .1;\nvoid f() { a = step; t.step(0); }"),
            "float a = step(1., 2.), shadertwin_step = .1;\nvoid f() { a = shadertwin_step; t.step(0); }");
  EXPECT_EQ(canonicalise("void f(float step) { float mix = step; }"),
            "void f(float step) { float mix = step; }");
}

TEST(Canonicalise, RenamesOverloadsOfAllBuiltinsInEs100) {
  const std::string text = canonicalise(
      "float equal(float a, float b) { return 1.0; } bool f() { return equal(vec2(1.0)); }", true);
  EXPECT_NE(text.find("bvec2 shadertwin_equal(vec2 a, vec2 b) { return equal(a, b); }"), std::string::npos)
      << text;
  EXPECT_NE(text.find("bvec4 shadertwin_equal(bvec4 a, bvec4 b) { return equal(a, b); }"), std::string::npos)
      << text;
  EXPECT_NE(text.find("float shadertwin_equal(float a, float b) { return 1.0; }"), std::string::npos) << text;
  EXPECT_NE(text.find("return shadertwin_equal(vec2(1.0))"), std::string::npos) << text;
  EXPECT_EQ(canonicalise("float equal(float a) { return a; }"), "float equal(float a) { return a; }");
}

TEST(Canonicalise, RenamesOverloadsOfOpenBuiltinsAndForwardsTheOthers) {
  const std::string text =
      canonicalise("float mix(float a, in float b, float t) { return a; }\nvoid f() { mix(a, b, c); }");
  EXPECT_EQ(text.find("float shadertwin_mix(float a, float b, float c)"), std::string::npos) << text;
  EXPECT_NE(text.find("vec2 shadertwin_mix(vec2 a, vec2 b, float c) { return mix(a, b, c); } "),
            std::string::npos);
  EXPECT_NE(text.find("float shadertwin_mix(float a, in float b, float t) { return a; }\nvoid f() { "
                      "shadertwin_mix(a, b, c); }"),
            std::string::npos)
      << text;
}

TEST(Canonicalise, GivesTheLastLabelAStatement) {
  EXPECT_EQ(canonicalise("switch (k) { case 1: ; case 2: ; }"), "switch (k) { case 1: ; case 2: break; ; }");
  EXPECT_EQ(canonicalise("switch (k) { case 1: {} default: { {;} } }"),
            "switch (k) { case 1: {} default: break; { {;} } }");
}

TEST(Canonicalise, RenamesStructuresNamedAsBuiltins) {
  EXPECT_EQ(canonicalise(
                "void f() { struct exp2 { float a; }; exp2 e = exp2(1.); } float g() { return exp2(1.); }"),
            "void f() { struct shadertwin_exp2 { float a; }; shadertwin_exp2 e = shadertwin_exp2(1.); } "
            "float g() { return exp2(1.); }");
}

TEST(Canonicalise, LeavesMembersThatAreCalledAsWhatItRenames) {
  EXPECT_EQ(canonicalise("struct fma { float a[2], fma; }; float f(fma x) { return x.fma; }"),
            "struct shadertwin_fma { float a[2], fma; }; float f(shadertwin_fma x) { return x.fma; }");
  EXPECT_EQ(canonicalise("float sin; struct S { float sin; }; float f(S s) { return s.sin + sin; }"),
            "float shadertwin_sin; struct S { float sin; }; float f(S s) { return s.sin + shadertwin_sin; }");
}

TEST(Canonicalise, RenamesMembersCalledLength) {
  EXPECT_EQ(
      canonicalise(
          "struct S { float length, x; };\nfloat f(S s) { return s.length + length(s.x) + a.length(); }"),
      "struct S { float shadertwin_length, x; };\nfloat f(S s) { return s.shadertwin_length + length(s.x) + "
      "a.length(); }");
}

}  // namespace
}  // namespace shadertwin
