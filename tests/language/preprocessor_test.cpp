#include "host/language/preprocessor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/language/repeated.h"

namespace shadertwin {
namespace {

const std::string folder = std::string(SHADERTWIN_SOURCE_DIR) + "/tests/language/";

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

struct Case {
  std::string name;
  std::string verdict;
  int line = 0;  // of the first error; 0 if any will do
  bool whole = false;
  bool repeats = false;  // part of the text many times
  std::string text;

  PlainText plain() const { return preprocess(text, {.behind_head = !whole}); }
};

// U+27E6 text * count U+27E7
bool unfold_repetitions(std::string& text) {
  const std::string_view open = "\u27E6", close = "\u27E7";
  bool any = false;
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos; any = true) {
    const std::size_t end = text.find(close, at);
    const std::string inner = text.substr(at + open.size(), end - at - open.size());
    const std::size_t star = inner.rfind('*');
    const std::string unfolded = repeated(inner.substr(0, star), std::stoi(inner.substr(star + 1)));
    text.replace(at, end + close.size() - at, unfolded);
    at += unfolded.size();
  }
  return any;
}

// The cases of the file, whose first lines say how it is written.
std::vector<Case> read_cases() {
  std::vector<Case> cases;
  std::istringstream file(contents(folder + "preprocessor_cases.txt"));
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("--- ")) {
      if (!cases.empty()) cases.back().text += line + "\n";
      continue;
    }
    Case next;
    const std::size_t colon = line.rfind(": ");
    next.name = line.substr(4, colon - 4);
    std::istringstream verdict(line.substr(colon + 2));
    verdict >> next.verdict;
    if (!(verdict >> next.line)) verdict.clear();
    std::string whole;
    next.whole = verdict >> whole && whole == "whole";
    cases.push_back(next);
  }
  for (Case& each : cases) {
    each.repeats = unfold_repetitions(each.text);
    replace_all(each.text, "\u240D", "\r");
    replace_all(each.text, "\u240B", "\v");
    replace_all(each.text, "\u240C", "\f");
    each.text.resize(std::min(each.text.find("\u2404"), each.text.size()));
  }
  return cases;
}

std::string errors_of(const PlainText& text) {
  std::string result;
  for (const Diagnostic& error : text.errors)
    result += std::to_string(error.line) + ": " + error.message + "\n";
  return result;
}

std::string joined(std::string_view text, const PreprocessOptions& options = {}) {
  const PlainText plain = preprocess(text, options);
  EXPECT_EQ(errors_of(plain), "");
  std::string result;
  for (const PlainToken& token : plain.tokens)
    result += (result.empty() ? "" : " ") + token.text + "@" + std::to_string(token.line);
  return result;
}

std::string first_error(std::string_view text) {
  const PlainText plain = preprocess(text);
  return plain.errors.empty() ? "" : plain.errors.front().message;
}

TEST(Preprocessor, JudgesEveryCaseAsTheBrowserDoes) {
  const std::vector<Case> cases = read_cases();
  EXPECT_GT(cases.size(), 400U);
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    const PlainText plain = each.plain();
    if (each.verdict != "refused") {
      EXPECT_EQ(errors_of(plain), "");
      continue;
    }
    ASSERT_FALSE(plain.errors.empty());
    if (each.line != 0) {
      EXPECT_EQ(plain.errors.front().line, each.line) << errors_of(plain);
    }
  }
}

// The plain text of every green case, as it was reviewed. SHADERTWIN_UPDATE_GOLDENS=1 writes it anew.
TEST(Preprocessor, GreenCasesBecomeTheTextThatWasReviewed) {
  const std::string path = folder + "preprocessor_cases.plain.txt";
  std::string plain;
  for (const Case& each : read_cases())
    if (each.verdict == "green" && !each.repeats)
      plain += "--- " + each.name + (each.whole ? ": whole\n" : ":\n") +
               to_text(each.plain(), count_lines(each.text));
  if (std::getenv("SHADERTWIN_UPDATE_GOLDENS") != nullptr) std::ofstream(path, std::ios::binary) << plain;
  EXPECT_EQ(plain, contents(path));
}

// What comes out has nothing left to do: it comes out of a second pass as it is.
TEST(Preprocessor, PlainTextIsPlain) {
  for (const Case& each : read_cases()) {
    if (each.verdict == "refused") continue;
    SCOPED_TRACE(each.name);
    const int lines = count_lines(each.text);
    const std::string once = to_text(each.plain(), lines);
    EXPECT_EQ(std::count(once.begin(), once.end(), '\n'), lines);
    EXPECT_EQ(to_text(preprocess(once, {.behind_head = !each.whole}), lines), once);
  }
}

TEST(Preprocessor, LinesNeverDecrease) {
  for (const Case& each : read_cases()) {
    SCOPED_TRACE(each.name);
    int line = 1;
    for (const PlainToken& token : each.plain().tokens) {
      ASSERT_LE(line, token.line);
      line = token.line;
    }
    EXPECT_LE(line, count_lines(each.text));
  }
}

// Every case cut off anywhere, and with any of its characters gone.
TEST(Preprocessor, SurvivesTruncationsAndDeletions) {
  for (const Case& each : read_cases()) {
    if (each.repeats) continue;
    for (std::size_t i = 0; i < each.text.size(); ++i) {
      const std::string without = each.text.substr(0, i) + each.text.substr(i + 1);
      for (const std::string& damaged : {each.text.substr(0, i), without}) {
        const int lines = count_lines(damaged);
        const std::string text = to_text(preprocess(damaged), lines);
        ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), lines) << damaged;
      }
    }
  }
}

TEST(Preprocessor, TokensStandInTheLineOfTheInvocation) {
  EXPECT_EQ(joined("#define A b c\n\nA\nd"), "b@3 c@3 d@4");
  EXPECT_EQ(joined("#define F(x) x b\nF(\na\n)\nd"), "a@4 b@4 d@5");
  EXPECT_EQ(joined("a \\\n b\n\r\nc\rd"), "a@1 b@2 c@4 d@5");
  EXPECT_EQ(joined("a\n#line 1\nb __LINE__"), "a@1 b@3 1@3");
}

TEST(Preprocessor, PredefinedNamesMayBeDefinedAnew) {
  const PreprocessOptions options = {.predefined = {{"A", "1 + x"}, {"E", ""}}};
  EXPECT_EQ(joined("A E", options), "1@1 +@1 x@1");
  EXPECT_EQ(joined("#define A 2\nA", options), "2@2");
  EXPECT_EQ(joined("#undef A\nA", options), "A@2");
  EXPECT_EQ(joined("#if A == 2 && defined E\nyes\n#endif", {.predefined = {{"A", "2"}, {"E", ""}}}), "yes@2");
  EXPECT_FALSE(preprocess("#define A 2\n#define A 3", options).errors.empty());
  const PreprocessOptions call = {.predefined = {{"F", "g(b, a)", {"a", "b"}}}};
  EXPECT_EQ(joined("F(1, F(2, 3)) F", call), "g@1 (@1 g@1 (@1 3@1 ,@1 2@1 )@1 ,@1 1@1 )@1 F@1");
  EXPECT_EQ(joined("#define F(x) x\nF(1)", call), "1@2");
}

TEST(Preprocessor, PragmasAndExtensionsStayForTheCompiler) {
  const std::string text =
      "#version 300 es\n#extension  GL_FOO:warn\n#pragma optimize ( on )\nfloat x;\n#pragma foo bar\n";
  const PlainText plain = preprocess(text, {.behind_head = false});
  EXPECT_EQ(errors_of(plain), "");
  EXPECT_EQ(to_text(plain, 5),
            "\n#extension GL_FOO : warn\n#pragma optimize ( on )\nfloat x;\n#pragma foo bar\n");
}

TEST(Preprocessor, ABackslashBehindAContinuedLineEndsTheText) {
  const PlainText cut = preprocess("a // \\\n\\\nb");
  EXPECT_TRUE(cut.errors.empty());
  EXPECT_EQ(cut.tokens.size(), 1U);
}

TEST(ToText, TokensNeverJoin) {
  const auto text = [](std::string_view t) { return to_text(preprocess(t), 1); };
  EXPECT_EQ(preprocess("#define M -\n#define E\n-M-E-1").errors.size(), 0U);
  EXPECT_EQ(to_text(preprocess("#define M -\n#define E\n-M-E-1"), 3), "\n\n- - - -1\n");
  EXPECT_EQ(to_text(preprocess("#define A x\n#define D 1.\nA/**/y D/**/0 A.x"), 3), "\n\nx y 1. 0 x.x\n");
  EXPECT_EQ(text("a+b(c,d)[0].x*=-1.;"), "a+b(c,d)[0].x*= -1.;\n");
}

TEST(ToText, WhatIsBeyondTheLinesIsOnTheLast) {
  EXPECT_EQ(to_text(preprocess("a\nb\nc"), 2), "a\nb c\n");
  EXPECT_EQ(to_text(preprocess("a"), 3), "a\n\n\n");
}

TEST(Limits, MacroBombsStopWithTheLimitInTheMessage) {
  const auto bomb = [](const std::string& zero, const std::string& body) {
    std::string text = "#define A0 " + zero + "\n";
    for (int i = 1; i < 40; ++i) {
      std::string line = body;
      replace_all(line, "A", "A" + std::to_string(i - 1));
      text += "#define A" + std::to_string(i) + " " + line + "\n";
    }
    return text;
  };
  EXPECT_NE(first_error(bomb("1.0", "(A+A)") + "A39").find("more than 1000000 tokens"), std::string::npos);
  EXPECT_NE(first_error(bomb("", "A A") + "A39").find("more than 4000000 tokens"), std::string::npos);
  EXPECT_NE(first_error(bomb("1", "(A+A)") + "#if A39\n#endif").find("more than 4000000 tokens"),
            std::string::npos);
  std::string functions = "#define F0(x) x x\n";
  for (int i = 1; i < 40; ++i)
    functions += "#define F" + std::to_string(i) + "(x) F" + std::to_string(i - 1) + "(x x)\n";
  EXPECT_NE(first_error(functions + "F39(1)").find("more than 10000 tokens"), std::string::npos);
}

TEST(Limits, DepthStopsWithTheLimitInTheMessage) {
  const auto nested = [](int depth) { return repeated("F(", depth) + "1" + repeated(")", depth); };
  EXPECT_EQ(first_error("#define F(x) x\n" + nested(1000)), "");
  EXPECT_NE(first_error("#define F(x) x\n" + nested(1001)).find("more than 1000 times"), std::string::npos);
  EXPECT_NE(first_error("#define F(x) x\n" + nested(300000)), "");
  const auto condition = [](int depth) {
    return "#if " + repeated("(", depth) + "1" + repeated(")", depth) + "\n#endif\n";
  };
  EXPECT_EQ(first_error(condition(9996)), "");
  EXPECT_NE(first_error(condition(9997)).find("more than 9999"), std::string::npos);
  EXPECT_NE(first_error(condition(100000)).find("more than 9999"), std::string::npos);
  EXPECT_EQ(first_error(repeated("#if 1\n", 100000) + repeated("#endif\n", 100000)), "");
}

TEST(Limits, NamesAreAsLongAsBrowsersTakeThem) {
  EXPECT_EQ(first_error(std::string(1024, 'x')), "");
  EXPECT_NE(first_error(std::string(1025, 'x')).find("longer than 1024 characters"), std::string::npos);
  EXPECT_NE(first_error(std::string(2'000'000, 'x')), "");
}

TEST(Limits, ErrorsAreAHundredAtMost) {
  EXPECT_EQ(preprocess(std::string(1000, '@')).errors.size(), 100U);
}

// Large texts of every shape, each done in less than a second: in quadratic time they would take hours, and
// CTest ends a test long before.
TEST(Limits, LargeTextsComeToAnEnd) {
  const std::string f = "#define F(x, y) ((x) + (y))\n";
  // Whether a browser refuses it, or a limit of ours does.
  const std::pair<bool, std::string> texts[] = {
      {false, repeated("float a = b * (c + 1.5); // d\n", 40000)},
      {false, repeated("#define A 1\n#undef A\n", 50000)},
      {true, f + repeated("F(F(1, 2), F(a, b));\n", 50000)},
      {true, repeated("#if defined(A) || (1 && !B)\n#else\n#endif\n", 25000)},
      {false, repeated("\\\n", 1) + repeated("a \\\n", 200000)},
      {false, repeated("/* */", 200000)},
      {false, "#define G(" +
                  [] {
                    std::string list = "a0";
                    for (int i = 1; i < 50000; ++i) list += ",a" + std::to_string(i);
                    return list + ") " + list;
                  }() +
                  "\n"},
      {true, "#define F(x) x\n" +
                 repeated(repeated("F(", 900) + repeated("1 ", 4000) + repeated(")", 900) + "\n", 90)},
      {false, std::string(1'000'000, '(')},
      {true, "#define F(x) x\n" + repeated("F(", 500000)},
      {true, std::string(1'000'000, '@')},
      {true, "#if 0\n" + repeated("'\"", 500000)},
  };
  for (const auto& [refused, text] : texts)
    EXPECT_EQ(!preprocess(text).errors.empty(), refused) << text.substr(0, 40) << "... of " << text.size();
}

}  // namespace
}  // namespace shadertwin
