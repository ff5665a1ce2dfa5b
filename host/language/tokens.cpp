#include "host/language/tokens.h"

#include <algorithm>
#include <array>

#include "host/language/characters.h"

namespace shadertwin {

namespace {

// Longest first.
constexpr std::array<std::string_view, 22> long_operators = {
    "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",
    "||",  "^^",  "+=", "-=", "*=", "/=", "%=", "&=", "^=", "|=", "::"};

class Scanner {
 public:
  Scanner(std::string_view text, const TokenizeOptions& options) : text_(text), options_(options) {}

  std::vector<Token> run() {
    while (skip_space()) scan();
    return std::move(tokens_);
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void newline() {
    if (options_.line_ends) push(Token::Kind::line_end, 1);
    ++line_;
    first_ = true;
    preprocessor_ = false;
  }

  // Length of a backslash with the line end that it hides; 0 if there is none at i.
  std::size_t continuation(std::size_t i) const {
    if (at(i) != '\\') return 0;
    if (at(i + 1) == '\n') return 2;
    return at(i + 1) == '\r' && at(i + 2) == '\n' ? 3 : 0;
  }

  // To the next token. False at the end of the text.
  bool skip_space() {
    space_ = at_ == 0;
    while (at_ < text_.size()) {
      if (const std::size_t hidden = continuation(at_)) {
        at_ += hidden;
        ++line_;
        continue;
      }
      if (text_[at_] == '\n') {
        newline();
        ++at_;
      } else if (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r')) {
        ++at_;
      } else if (at(at_) == '/' && at(at_ + 1) == '/') {
        skip_line_comment();
      } else if (at(at_) == '/' && at(at_ + 1) == '*') {
        skip_block_comment();
      } else {
        return true;
      }
      space_ = true;
    }
    return false;
  }

  void skip_line_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      const std::size_t hidden = continuation(at_);
      if (hidden != 0) ++line_;
      at_ += std::max<std::size_t>(hidden, 1);
    }
  }

  // A line end in a block comment does not end a # line.
  void skip_block_comment() {
    const std::size_t close = text_.find("*/", at_ + 2);
    const std::size_t end = close == std::string_view::npos ? text_.size() : close + 2;
    if (close == std::string_view::npos && options_.line_ends)
      push(Token::Kind::open_comment, text_.size() - at_);
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }

  void push(Token::Kind kind, std::size_t length) {
    Token token;
    token.kind = kind;
    token.text = text_.substr(at_, length);
    token.begin = at_;
    token.line = line_;
    token.first = first_;
    token.preprocessor = preprocessor_;
    token.space_before = space_;
    tokens_.push_back(token);
  }

  void scan() {
    const char c = text_[at_];
    Token::Kind kind = Token::Kind::punctuation;
    std::size_t end = at_ + 1;
    if (starts_word(c)) {
      kind = Token::Kind::identifier;
      while (in_word(at(end))) ++end;
    } else if (is_digit(c) || (c == '.' && is_digit(at(end)))) {
      kind = Token::Kind::number;
      end = number_end();
    } else if (options_.strings && (c == '"' || c == '\'')) {
      kind = scan_string(c, end);
    } else {
      end = at_ + operator_length();
    }
    if (c == '#' && first_) preprocessor_ = true;
    push(kind, end - at_);
    first_ = false;
    at_ = end;
  }

  std::size_t operator_length() const {
    constexpr std::string_view second = "<>+-=&|^:";  // in any of the long ones
    if (second.find(at(at_ + 1)) == std::string_view::npos) return 1;
    const std::string_view rest = text_.substr(at_, 3);
    for (const std::string_view op : long_operators)
      if (rest.starts_with(op)) return op.size();
    return 1;
  }

  // Digits, letters and points, as far as they go: 1.x and 08 are one token, too. A sign belongs to it only
  // within the exponent of a decimal number, which it can't be followed by more than digits and an f.
  std::size_t number_end() const {
    std::size_t end = at_;
    bool decimal = true;
    int points = 0;
    while (in_word(at(end)) || at(end) == '.') {
      const char c = at(end);
      if (decimal && (c == 'e' || c == 'E') && (at(end + 1) == '+' || at(end + 1) == '-') &&
          is_digit(at(end + 2))) {
        end += 2;
        while (is_digit(at(end))) ++end;
        return at(end) == 'f' || at(end) == 'F' ? end + 1 : end;
      }
      points += c == '.' ? 1 : 0;
      decimal = decimal && (is_digit(c) || c == '.') && points < 2;
      ++end;
    }
    return end;
  }

  Token::Kind scan_string(char quote, std::size_t& end) const {
    while (end < text_.size() && text_[end] != quote) {
      if (text_[end] == '\n') return Token::Kind::open_string;
      end += text_[end] == '\\' && at(end + 1) != '\n' ? 2 : 1;
    }
    if (end >= text_.size()) {
      end = text_.size();
      return Token::Kind::open_string;
    }
    ++end;
    return Token::Kind::string;
  }

  std::string_view text_;
  TokenizeOptions options_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool first_ = true;
  bool preprocessor_ = false;
  bool space_ = false;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, const TokenizeOptions& options) {
  return Scanner(text, options).run();
}

bool mentions(const std::vector<Token>& tokens, std::string_view name) {
  return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) {
    return token.kind == Token::Kind::identifier && token.text == name;
  });
}

bool declares(const std::vector<Token>& tokens, std::string_view name, bool macros) {
  int depth = 0;  // of braces and parentheses
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind == Token::Kind::punctuation && !token.preprocessor) {
      if (token.is("{") || token.is("(")) ++depth;
      // A macro may have opened it.
      if (token.is("}") || token.is(")")) depth = std::max(depth - 1, 0);
    }
    if (token.kind != Token::Kind::identifier || token.text != name || i == 0) continue;
    const Token& before = tokens[i - 1];
    if (token.preprocessor) {
      if (macros && before.is("define") && i >= 2 && tokens[i - 2].is("#")) return true;
      continue;
    }
    if (before.preprocessor || before.is("return") || before.is("else")) continue;
    // Conditional compilation may open a brace twice, so functions, which can't be nested, are found
    // anywhere.
    const bool typed = before.kind == Token::Kind::identifier || before.is("]");
    const bool function = i + 1 < tokens.size() && tokens[i + 1].is("(");
    if (typed && (function || depth == 0)) return true;
    if (before.is(",") && depth == 0) return true;
  }
  return false;
}

}  // namespace shadertwin
