// What the C++ of a shader looks like where pixels run in packets: which values and ways are one for all
// pixels, and what runs under a mask.
#include <gtest/gtest.h>

#include "tests/emit/emitted.h"

namespace shadertwin {
namespace {

std::string packets(const std::string& functions) {
  CppOptions options;
  options.packets = true;
  return emitted(functions, options);
}

TEST(EmitPackets, ValuesThatMayDifferArePackets) {
  EXPECT_TRUE(contains(packets("uniform float k; float f(float x) { return x * k; } float g() { return "
                               "f(gl_FragCoord.x) + 1.0; }"),
                       "Float f(Bool active, Float x) {\nreturn x * k;\n}\n"));
}

TEST(EmitPackets, WhatAllPixelsShareStaysScalar) {
  const std::string text = packets(
      "uniform float k; float f() { mat2 m = mat2(k); vec2 v = m * vec2(1.0); float s = 0.0; for (int i = 0; "
      "i "
      "< 3; i++) s += v.x * float(i); return s; }");
  EXPECT_TRUE(contains(text, "float f(Bool active) {\nuniform::mat2 m = "));
  EXPECT_TRUE(contains(text, "for (int i = 0; i < 3; i++) {\ns += v.x * float(i);\n}\n"));
}

TEST(EmitPackets, ParametersVaryIfAnyCallSaysSo) {
  EXPECT_TRUE(
      contains(packets("float f(float x) { return x; } float g() { return f(1.0) + f(gl_FragCoord.y); }"),
               "Float f(Bool active, Float x)"));
  EXPECT_TRUE(contains(packets("float f(float x) { return x; } float g() { return f(1.0) + f(2.0); }"),
                       "float f(Bool active, float x)"));
}

TEST(EmitPackets, BranchRunsUnderTheMaskOfThosePixelsThatTakeIt) {
  EXPECT_TRUE(
      contains(packets("float f() { float x = gl_FragCoord.x; float y = 0.0; if (x < 2.0) { y = x; float "
                       "z = x; z = 1.0; } return y; }"),
               "if (Bool active_2 = active && (x < 2.0f); any__(active_2)) {\nset__(active_2, y, x);\nFloat "
               "z = x;\nz = "
               "1.0f;\n}\nreturn y;\n"));
}

TEST(EmitPackets, BranchThatAllPixelsTakeTogetherHasNoMask) {
  EXPECT_TRUE(contains(packets("uniform float k; float f() { float y = gl_FragCoord.x; if (k < 2.0) y = 1.0; "
                               "return y; }"),
                       "if (k < 2.0f) {\ny = 1.0f;\n}\n"));
}

TEST(EmitPackets, LoopTurnsUntilItsLastPixelHasLeft) {
  EXPECT_TRUE(
      contains(packets("float f() { float x = gl_FragCoord.x; for (int i = 0; i < 9; i++) { if (x > 3.0) "
                       "break; x += 1.0; } return x; }"),
               "Bool loop = active;\nint i = 0;\nfor (;; i++) {\nloop = loop && (i < 9);\nif (none__(loop)) "
               "break;\nBool active_2 = loop;\nif (Bool active_3 = active_2 && (x > 3.0f); any__(active_3)) "
               "{\nmask_out__(active_3, "
               "active_2, loop);\n}\nif (none__(active_2)) continue;\nset__(active_2, x, x + 1.0f);\n}\n"));
}

TEST(EmitPackets, FunctionGoesOnForThePixelsThatHaveNotReturned) {
  EXPECT_TRUE(contains(packets("float f() { if (gl_FragCoord.x < 2.0) return 1.0; return 2.0; }"),
                       "Float result{};\nif (Bool active_2 = active && (gl_FragCoord.x < 2.0f); "
                       "any__(active_2)) {\nset__(active_2, "
                       "result, 1.0f);\nmask_out__(active_2, active);\n}\nif (none__(active)) return "
                       "result;\nset__(active, result, "
                       "2.0f);\nreturn result;\n"));
}

TEST(EmitPackets, CheapChoicesNeedNoBranch) {
  EXPECT_TRUE(contains(packets("float f() { float x = gl_FragCoord.x; return x < 2.0 ? x : 1.0; }"),
                       "return select__(x < 2.0f, x, Float(1.0f));\n"));
}

TEST(EmitPackets, RightSideOfAnAndRunsForThosePixelsThatNeedIt) {
  const std::string text =
      packets("int n; bool f() { n++; return n > 3; } bool g() { return gl_FragCoord.x < 2.0 && f(); }");
  EXPECT_TRUE(
      contains(text,
               "const Bool tmp = gl_FragCoord.x < 2.0f;\nBool tmp_2 = tmp;\nif (Bool active_2 = active && "
               "tmp; any__(active_2)) {\nset__(active_2, tmp_2, f(active_2));\n}\nreturn tmp_2;\n"));
}

TEST(EmitPackets, ElementThatEachPixelChoosesIsPutBack) {
  EXPECT_TRUE(contains(
      packets("float f() { float a[3]; a[int(gl_FragCoord.x)] = 2.0; return a[0]; }"),
      "Float element = at(a, tmp);\nelement = 2.0f;\nput__(active, a, tmp, element);\nreturn a[0];\n"));
}

TEST(EmitPackets, DiscardedPixelsRunNoFurther) {
  const std::string text =
      packets("void f() { if (gl_FragCoord.x < 2.0) discard; } float g() { f(); return gl_FragCoord.x; }");
  EXPECT_TRUE(contains(text, "alive__ = alive__ && !active_2;\nmask_out__(active_2, active);\n"));
  EXPECT_TRUE(contains(text, "f(active);\nkeep__(alive__, active);\nif (none__(active)) return {};\n"));
}

}  // namespace
}  // namespace shadertwin
