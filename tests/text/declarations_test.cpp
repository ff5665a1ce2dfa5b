// Which declaration a name means.
#include "host/text/declarations.h"

#include <gtest/gtest.h>

#include <memory>

namespace shadertwin {
namespace {

// The token that declares what the nth token `name` of a text means.
class Scopes : public testing::Test {
 protected:
  void scan(const std::string& text) {
    tokens_ = split_tokens(text);
    declarations_ = std::make_unique<Declarations>(tokens_);
  }
  int token(const std::string& name, int nth) const {
    for (int i = 0; i < static_cast<int>(tokens_.size()); ++i) {
      if (tokens_[i].text == name && nth-- == 0) return i;
    }
    return -1;
  }
  int declared(const std::string& name, int nth) const {
    return declarations_->declaration_of(token(name, nth));
  }

  std::vector<PlainToken> tokens_;
  std::unique_ptr<Declarations> declarations_;
};

TEST_F(Scopes, InnerNameHidesTheOuterUntilItsBlockEnds) {
  scan("void f() { float a; { float a; a; } a; }");
  EXPECT_EQ(declared("a", 2), token("a", 1));
  EXPECT_EQ(declared("a", 3), token("a", 0));
}

TEST_F(Scopes, InitialiserReadsTheOuterName) {
  scan("float a; void f() { float a = a; a; }");
  EXPECT_EQ(declared("a", 2), token("a", 0));
  EXPECT_EQ(declared("a", 3), token("a", 1));
}

TEST_F(Scopes, LoopVariableEndsWithALoopWithoutBraces) {
  scan("void f() { float i; for (int i = 0; i < 3; i++) if (i > 1) i; else i; i; }");
  EXPECT_EQ(declared("i", 6), token("i", 1));
  EXPECT_EQ(declared("i", 7), token("i", 0)) << "after the loop";
}

TEST_F(Scopes, MembersAreNoVariables) {
  scan("struct S { float a; }; void f(S s, float a) { s.a; a; }");
  EXPECT_EQ(declared("a", 2), -1);
  EXPECT_EQ(declared("a", 3), token("a", 1));
}

TEST_F(Scopes, ConstructorsAreNoDeclarations) {
  scan("struct S { int x; }; void f(int x) { S s = S(x); float[2](1.0, 2.0); float[2] t; vec2(x); }");
  EXPECT_EQ(declared("x", 2), token("x", 1));
  EXPECT_EQ(declared("t", 0), token("t", 0));
}

TEST_F(Scopes, ConstIsKnown) {
  scan("const lowp int n = 3; void f() { highp const float a = 1.0, b = 2.0; float c; }");
  EXPECT_TRUE(declarations_->is_const(token("n", 0)));
  EXPECT_TRUE(declarations_->is_const(token("b", 0)));
  EXPECT_FALSE(declarations_->is_const(token("c", 0)));
}

TEST(Tokens, TakeADirectiveForOne) {
  const std::vector<PlainToken> tokens = split_tokens("a\n#extension GL_A : warn\nb <<= 1.5e-3;\n#pragma b");
  ASSERT_EQ(tokens.size(), 7U);
  EXPECT_EQ(tokens[0].line, 1);
  EXPECT_EQ(tokens[1].text, "#extension GL_A : warn");
  EXPECT_EQ(tokens[1].line, 2);
  EXPECT_EQ(tokens[2].line, 3);
  EXPECT_EQ(tokens[3].text, "<<=");
  EXPECT_EQ(tokens[4].text, "1.5e-3");
  EXPECT_EQ(tokens[6].text, "#pragma b");
}

}  // namespace
}  // namespace shadertwin
