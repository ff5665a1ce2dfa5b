// Texts that are nested too deeply for a compiler's stack are refused, and none that a browser takes.
#include "host/language/nesting.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/language/repeated.h"

namespace shadertwin {
namespace {

std::optional<Diagnostic> judged(const std::string& code) {
  const PlainText plain = preprocess(code);
  EXPECT_TRUE(plain.errors.empty());
  return nested_too_deeply(plain.tokens);
}

// A statement with `count` operators, brackets or statements within each other.
struct Shape {
  const char* name;
  std::string (*write)(int count);
};

const Shape shapes[] = {
    {"Sum", [](int n) { return "x = x" + repeated(" + x", n) + ";"; }},
    {"Parentheses", [](int n) { return "x = " + repeated("(", n) + "x" + repeated(")", n) + ";"; }},
    {"Signs", [](int n) { return "x = " + repeated("- ", n) + "x;"; }},
    {"Choices", [](int n) { return "x = " + repeated("x < 1. ? 2. : ", n) + "x;"; }},
    {"Calls", [](int n) { return "x = " + repeated("sin(", n) + "x" + repeated(")", n) + ";"; }},
    {"SecondArguments",
     [](int n) { return "x = " + repeated("max(1., ", n) + "x" + repeated(")", n) + ";"; }},
    {"Indices", [](int n) { return "x = a" + repeated("[0]", n) + ";"; }},
    {"NestedIndices", [](int n) { return "x = " + repeated("a[", n) + "0" + repeated("]", n) + ";"; }},
    {"Fields", [](int n) { return "x = a" + repeated(".x", n) + ";"; }},
    {"Assignments", [](int n) { return repeated("x = ", n) + "1.;"; }},
    {"Commas", [](int n) { return "x = 1." + repeated(", x = 1.", n) + ";"; }},
    {"CommasInParentheses", [](int n) { return "x = (1." + repeated(", 1.", n) + ");"; }},
    {"Blocks", [](int n) { return repeated("{", n) + "x;" + repeated("}", n); }},
    {"Ifs", [](int n) { return repeated("if (b) ", n) + "x;"; }},
    {"IfBlocks", [](int n) { return repeated("if (b) {", n) + "x;" + repeated("}", n); }},
    {"ElseIfs", [](int n) { return repeated("if (b) x; else ", n) + "x;"; }},
    {"ElseIfBlocks", [](int n) { return repeated("if (b) { x; } else ", n) + "x;"; }},
    {"Loops", [](int n) { return repeated("for (;;) ", n) + "x;"; }},
    {"WithoutEnds", [](int n) { return repeated("if (b) { x = (1. + ", n); }},
};

class Nesting : public testing::TestWithParam<Shape> {};

TEST_P(Nesting, RefusesWhatIsDeeper) {
  const auto found = judged("void f() {\n" + GetParam().write(deepest_nesting + 1) + "\n}");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 2);
  EXPECT_EQ(found->message, "operators, brackets or statements nested more than 4000 deep");
}

// Browsers refuse more than 254, 126 for `if`.
TEST_P(Nesting, TakesWhatBrowsersTake) {
  EXPECT_FALSE(judged("void f() {\n" + GetParam().write(300) + "\n}").has_value());
}

// However many statements stand behind each other.
TEST_P(Nesting, CountsNothingThatIsOver) {
  if (std::string(GetParam().name) == "WithoutEnds") return;
  EXPECT_FALSE(judged("void f() {\n" + repeated(GetParam().write(5) + "\n", 3000) + "}").has_value());
}

INSTANTIATE_TEST_SUITE_P(, Nesting, testing::ValuesIn(shapes),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(NestingOfText, TakesLongListsOfArguments) {
  EXPECT_FALSE(judged("const float a[] = float[](" + repeated("-1. * 2., ", 20000) + "1.);").has_value());
}

std::string nested_structures(int count) {
  std::string text = "struct S1 { float x; };";
  for (int i = 2; i <= count; ++i) {
    const std::string inner = "S" + std::to_string(i - 1);
    text += "\nstruct S" + std::to_string(i) + " { " + inner + " a; vec2 " + inner + ", b[2]; " + inner +
            " c; };";
  }
  return text;
}

TEST(NestingOfText, RefusesStructuresThatBrowsersRefuse) {
  EXPECT_FALSE(judged(nested_structures(4)).has_value());
  const auto found = judged(nested_structures(27));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 5);
  EXPECT_EQ(found->message, "structures nested more than 4 deep");
}

TEST(NestingOfText, TakesMembersNamedAfterStructures) {
  EXPECT_FALSE(judged("struct A { float x; }; struct B { float A; }; struct C { float B; };"
                      "struct D { float C; }; struct E { float D, A; };")
                   .has_value());
}

TEST(NestingOfText, TakesWhatIsNoGlsl) {
  for (const char* text : {")", "}}}", "]);", ",,,", "else", "( { [", "struct", "struct {", ""})
    EXPECT_FALSE(judged(text).has_value()) << text;
}

}  // namespace
}  // namespace shadertwin
