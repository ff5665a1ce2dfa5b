// GLSL as tokens: what directives, entry points and renames are found by. Comments and continued lines are
// skipped as the language says; nothing is preprocessed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shadertwin {

struct Token {
  // A string that its line ends before its quote is `open_string`: an apostrophe in an #error line is one.
  // `line_end` and `open_comment`, a comment that the text ends in, are there only if asked for.
  enum class Kind { identifier, number, string, open_string, punctuation, line_end, open_comment };
  Kind kind = Kind::punctuation;
  std::string_view text;  // into the tokenized text; of a string with its quotes
  std::size_t begin = 0;
  int line = 1;               // physical line, from 1
  bool first = false;         // nothing but space and comments stands before it on its line
  bool preprocessor = false;  // part of a # line
  bool space_before = false;  // space, a comment or a line's start stands before it

  std::size_t end() const { return begin + text.size(); }
  bool is(std::string_view s) const { return text == s; }
};

struct TokenizeOptions {
  bool strings = true;     // GLSL has none: without, a quote is punctuation
  bool line_ends = false;  // whether a line's end is a token, outside of comments, and an open comment is one
};

// The tokens of `text`, which must outlive them. Operators such as <<= and "::" are one token each.
std::vector<Token> tokenize(std::string_view text, const TokenizeOptions& options = {});

// Whether some identifier is `name`.
bool mentions(const std::vector<Token>& tokens, std::string_view name);

// Whether the text gives `name` a meaning outside of functions: a variable, a function or, if `macros`,
// #define.
bool declares(const std::vector<Token>& tokens, std::string_view name, bool macros = true);

// `text` with every identifier that `rename` gives another name; comments and lines stay as they are.
// rename: std::string_view -> std::string_view, the same for "leave it".
template <typename Rename>
std::string rename_identifiers(std::string_view text, Rename rename) {
  std::string result;
  std::size_t copied = 0;
  for (const Token& token : tokenize(text)) {
    if (token.kind != Token::Kind::identifier) continue;
    const std::string_view name = rename(token.text);
    if (name == token.text) continue;
    result.append(text.substr(copied, token.begin - copied)).append(name);
    copied = token.end();
  }
  return result.append(text.substr(copied));
}

}  // namespace shadertwin
