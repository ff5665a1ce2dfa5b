#include "host/language/tokens.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

std::string words(std::string_view text) {
  std::string result;
  for (const Token& token : tokenize(text))
    result += (result.empty() ? "" : " ") + std::string(token.text) + "@" + std::to_string(token.line);
  return result;
}

TEST(Tokens, CommentsAreSkippedAndLinesCounted) {
  EXPECT_EQ(words("a // b\nc /* d\ne */ f"), "a@1 c@2 f@3");
  EXPECT_EQ(words("/*/ still a comment */ a"), "a@1");
  EXPECT_EQ(words("// continued \\\n a\nb"), "b@3");
}

TEST(Tokens, ContinuedLinesKeepTheirPhysicalNumbers) {
  EXPECT_EQ(words("#define A \\\n 1\nB"), "#@1 define@1 A@1 1@2 B@3");
  EXPECT_EQ(words("#define A \\\r\n 1\r\nB"), "#@1 define@1 A@1 1@2 B@3");
}

TEST(Tokens, NumbersAreWhole) {
  EXPECT_EQ(words("1.5e-3f+.5 0x1F-1"), "1.5e-3f@1 +@1 .5@1 0x1F@1 -@1 1@1");
}

TEST(Tokens, ASignBelongsToADecimalExponentOnly) {
  EXPECT_EQ(words("1.e+3 1e-3f 0x1e+3"), "1.e+3@1 1e-3f@1 0x1e@1 +@1 3@1");
  EXPECT_EQ(words("1e+ 1..2e+3 1e+3x"), "1e@1 +@1 1..2e@1 +@1 3@1 1e+3@1 x@1");
}

TEST(Tokens, OperatorsAreWhole) {
  EXPECT_EQ(words("a<<=b>>c<=d++ +--e"), "a@1 <<=@1 b@1 >>@1 c@1 <=@1 d@1 ++@1 +@1 --@1 e@1");
}

TEST(Tokens, SpaceBeforeATokenIsKnown) {
  std::string spaced;
  for (const Token& token : tokenize("a+ b/**/c\nd(e\\\nf")) spaced += token.space_before ? "1" : "0";
  EXPECT_EQ(spaced, "10111000");
}

TEST(Tokens, WithoutStringsAQuoteIsPunctuation) {
  const std::vector<Token> tokens = tokenize("\"/*\"*/ 'a", {.strings = false});
  ASSERT_EQ(tokens.size(), 3U);
  EXPECT_EQ(tokens[0].text, "\"");
  EXPECT_EQ(tokens[1].text, "'");
  EXPECT_EQ(tokens[2].text, "a");
}

TEST(Tokens, LineEndsAndAnOpenCommentAreTokensIfAskedFor) {
  std::string kinds;
  for (const Token& token : tokenize("a // b\n\n/*\n*/ c\n/* d\n", {.line_ends = true}))
    kinds += (token.kind == Token::Kind::line_end       ? "\\"
              : token.kind == Token::Kind::open_comment ? "*"
                                                        : std::string(token.text)) +
             std::to_string(token.line);
  EXPECT_EQ(kinds, "a1\\1\\2c4\\4*5");
}

TEST(Tokens, AnApostropheEndsWithItsLine) {
  const std::vector<Token> tokens = tokenize("#error don't\nint x;");
  ASSERT_EQ(tokens.size(), 7U);
  EXPECT_EQ(tokens[3].kind, Token::Kind::open_string);
  EXPECT_EQ(tokens[4].text, "int");
}

TEST(Declares, SeesMacrosVariablesAndFunctionsButNoUses) {
  const auto found = [](std::string_view text) { return declares(tokenize(text), "saturate"); };
  EXPECT_TRUE(found("#define saturate(x) clamp(x, 0., 1.)"));
  EXPECT_TRUE(found("float saturate(float x) { return x; }"));
  EXPECT_TRUE(found("float a, saturate = 1.0;"));
  EXPECT_TRUE(
      found("#if 0\nvoid f() {\n#else\nvoid f() {\n#endif\n}\nfloat saturate(float x) { return x; }"));
  EXPECT_FALSE(found("float f(float x) { return saturate(x); }"));
  EXPECT_FALSE(found("#define twice(x) saturate(x)"));
  EXPECT_FALSE(found("// float saturate(float x) {}"));
  EXPECT_FALSE(declares(tokenize("#define saturate 1"), "saturate", false));
}

TEST(RenameIdentifiers, LeavesCommentsAndPartsOfWordsAlone) {
  EXPECT_EQ(rename_identifiers(
                "main(); mainImage(); // main\n main",
                [](std::string_view name) -> std::string_view { return name == "main" ? "other" : name; }),
            "other(); mainImage(); // main\n other");
}

}  // namespace
}  // namespace shadertwin
