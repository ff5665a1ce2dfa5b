// What the text of a shader looks like whose every value is defined. What it draws is compared with the twin
// in tests/twin and with a browser in tests/web.
#include "host/text/define_undefined.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "host/base/error.h"
#include "host/text/load.h"
#include "host/text/make_precise.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

constexpr const char* plain_image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.0); }\n";

// The pass with this body, as a host wraps it.
Project project_of(const std::string& body) {
  const ScratchFolder folder;
  return load_project(folder.write("shader.glsl", body + plain_image),
                      {.settings = {.undefined = Undefined::raw}});
}

PassSource defined_source(const Project& project) {
  return define_undefined(project, project.passes[0].source).value();
}

std::string started(const std::string& body) {
  const std::string text = defined_source(project_of(body)).body;
  return text.substr(0, text.find("void mainImage"));
}

TEST(DefineUndefined, StartsVariablesAtZero) {
  EXPECT_EQ(started("vec3 g, h = vec3(1.0); const float k = 1.0; uniform int u;\n"),
            "vec3 g = vec3(0) , h = vec3 ( 1.0 ) ; const float k = 1.0 ; uniform int u ;\n");
  EXPECT_EQ(started("void f() { bvec2 b; for (float i, z; i < 1.0; i++) uint u; }\n"),
            "void f ( ) { bvec2 b = bvec2(false) ; for ( float i = 0.0 , z = 0.0 ; i < 1.0 ; i ++ ) uint u = "
            "0u ; }\n");
}

TEST(DefineUndefined, StartsArraysAndStructuresAtZero) {
  EXPECT_EQ(
      started("const int N = 3;\nstruct S { mat2 m, n; float f[N - 1]; };\nS s, t[2]; int[N] i;\n"),
      "const int N = 3 ;\nstruct S { mat2 m , n ; float f [ N - 1 ] ; } ;\n"
      "S s = S(mat2(0), mat2(0), float[2](0.0, 0.0)) , "
      "t [ 2 ] = S[2](S(mat2(0), mat2(0), float[2](0.0, 0.0)), S(mat2(0), mat2(0), float[2](0.0, 0.0))) ; "
      "int [ N ] i = int[3](0, 0, 0) ;\n");
}

TEST(DefineUndefined, StartsArraysThatFollowTheirStructureAtZero) {
  EXPECT_EQ(started("struct S { int i; } s, t[2];\n"),
            "struct S { int i ; } s = S(0) , t [ 2 ] = S[2](S(0), S(0)) ;\n");
}

TEST(DefineUndefined, StartsAStructureWhoseNameBeginsAsABuiltInTypes) {
  EXPECT_EQ(started("struct material { float a; };\nmaterial m;\n"),
            "struct material { float a ; } ;\nmaterial m = material(0.0) ;\n");
}

TEST(DefineUndefined, ClampsAnIndexThatParenthesesHideTheWriteOf) {
  const std::string text = started(
      "float q[4]; float f() { float s = 0.0; for (int i = 0; i < 4; i++) { (i) += 5; s += q[i]; } return s; "
      "}\n");
  EXPECT_NE(text.find("shadertwin_at( i , 3)"), std::string::npos) << text;
}

TEST(DefineUndefined, ClearsLongArraysByALoop) {
  EXPECT_NE(started("void f() { highp float a[999]; float b = a[0]; }\n").find("for (int shadertwin_i"),
            std::string::npos);
  EXPECT_EQ(started("void f() { float a[999], b; b = a[0]; }\n"),
            "void f ( ) { float a [ 999 ] , b = 0.0 ; for (int shadertwin_i = 0; shadertwin_i < a.length(); "
            "++shadertwin_i) a[shadertwin_i] = 0.0; b = a [ 0 ] ; }\n");
  const std::string tail = defined_source(project_of("float g[999];\n")).tail;
  EXPECT_NE(tail.find("void main ( ) { for (int shadertwin_i = 0; shadertwin_i < g.length();"),
            std::string::npos)
      << tail;
}

TEST(DefineUndefined, ClearsOutputsWhereTheirFunctionStarts) {
  EXPECT_EQ(started("struct S { int i; };\nvoid f(out S s, inout vec2 v, out float a[2]);\n"
                    "void f(out S s, inout vec2 v, out float a[2]) { }\n"),
            "struct S { int i ; } ;\nvoid f ( out S s , inout vec2 v , out float a [ 2 ] ) ;\n"
            "void f ( out S s , inout vec2 v , out float a [ 2 ] ) { s = S(0); a = float[2](0.0, 0.0); }\n");
}

TEST(DefineUndefined, ReturnsZeroWhereAFunctionEnds) {
  EXPECT_EQ(started("vec2 f(int i) { if (i > 0) return vec2(i); }\n"),
            "vec2 f ( int i ) { if ( i > 0 ) return vec2 ( i ) ; return vec2(0); }\n");
  EXPECT_EQ(started("int f(int i) { if (i > 0) i++; return i; }\nvoid g() { return; }\n"),
            "int f ( int i ) { if ( i > 0 ) i ++ ; return i ; }\nvoid g ( ) { return ; }\n");
}

TEST(DefineUndefined, ClampsIndicesThatAreNoConstants) {
  EXPECT_EQ(
      started(
          "const float t[3] = float[3](1.0, 2.0, 3.0);\n"
          "float f(int i, mat4 m, vec2 v) { return t[i] + m[i + 1][2] + v[t[i] > 1.0 ? i : 0] + t[2]; }\n"),
      "const float t [ 3 ] = float [ 3 ] ( 1.0 , 2.0 , 3.0 ) ;\n"
      "float f ( int i , mat4 m , vec2 v ) { return t [shadertwin_at( i , 2)] + "
      "m [shadertwin_at(( i + 1 ), 3)] [ 2 ] + "
      "v [shadertwin_at(( t [shadertwin_at( i , 2)] > 1.0 ? i : 0 ), 1)] + t [ 2 ] ; }\n");
}

TEST(DefineUndefined, LeavesIndicesThatALoopKeepsInside) {
  const auto clamps = [](const std::string& loop) {
    const std::string text =
        started("void h(inout int i);\nfloat f() { float a[4], s; " + loop + " return s; }\n");
    return text.find("shadertwin_at") != std::string::npos;
  };
  EXPECT_FALSE(clamps("for (int i = 0; i < 4; i++) s += a[i];"));
  EXPECT_FALSE(clamps("for (int i = 3; i >= 0; --i) s += a[i];"));
  EXPECT_FALSE(clamps("for (int i = 0; i < a.length(); ++i) s += a[i];"));
  EXPECT_TRUE(clamps("for (int i = 0; i < 5; i++) s += a[i];"));
  EXPECT_TRUE(clamps("for (int i = 0; i <= 4; i++) s += a[i];"));
  EXPECT_TRUE(clamps("for (int i = -1; i < 4; i++) s += a[i];"));
  EXPECT_TRUE(clamps("for (int i = 0; i < 4; i++) { i += 3; s += a[i]; }"));
  EXPECT_TRUE(clamps("for (int i = 0; i < 4; i++) { h(i); s += a[i]; }"));
  EXPECT_TRUE(clamps("for (int i = 0; i < 4; i += 3) s += a[i];"));
}

TEST(DefineUndefined, KeepsEveryLineWhereItWas) {
  const std::string body =
      "#define LOOP(x) for (int i; i < \\\n 3; i++) { x; }\n\nfloat f()\n{\n  float a;\n  LOOP(a += 1.0)\n  "
      "return a;\n}\n";
  const Project before = project_of(body);
  const PassSource& written = before.passes[0].source;
  const PassSource after = defined_source(before);
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(lines(after.head), lines(written.head));
  EXPECT_EQ(lines(after.body), lines(written.body));
  EXPECT_EQ(started(body),
            "\n\n\nfloat f ( )\n{\nfloat a = 0.0 ;\nfor ( int i = 0 ; i < 3 ; i ++ ) { a += 1.0 ; }\nreturn "
            "a ;\n}\n");
}

// What a user types is seldom whole: a brace is missing, or half of a line.
TEST(DefineUndefined, ReadsBrokenTexts) {
  const std::string whole =
      "#define M(a) (a * 2.0)\nstruct S { float a[3]; int b; } s, t[2];\nfloat g[999];\n"
      "int f(int i, out vec2 v, inout float w[3]) { if (i > 0) { return M(i); } else v.x = 1.0; }\n"
      "float h(S s) { float a[999]; for (int i = 0; i < 3; i++) { vec2 v; int k = f(i, v, s.a); a[k] = 1.0; "
      "}\n"
      "  do { switch (s.b) { case 1: s.b++; default: break; } } while (s.b < 3);\n  return a[s.b]; }\n";
  const Project project = project_of(whole);
  const auto read = [&](const std::string& body) {
    Project broken = project;
    broken.passes[0].source.body = body;
    define_undefined(broken, broken.passes[0].source);
    try {
      make_precise(broken, broken.passes[0].source);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::shader);
    }
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (std::ispunct(static_cast<unsigned char>(whole[i])) == 0) continue;
    read(whole.substr(0, i));
    read(std::string(whole).erase(i, 1));
  }
}

TEST(DefineUndefined, LeavesWhatItCannotReadToTheDriver) {
  const Project project = project_of("#if 1\n");
  EXPECT_FALSE(define_undefined(project, project.passes[0].source).has_value());
}

}  // namespace
}  // namespace shadertwin
