#include "host/language/tokens.h"

#include <algorithm>

namespace shadertwin {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool starts_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool in_word(char c) {
  return starts_word(c) || is_digit(c);
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    while (skip_space()) scan();
    return std::move(tokens_);
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  void newline() {
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
    while (at_ < text_.size()) {
      if (const std::size_t hidden = continuation(at_)) {
        at_ += hidden;
        ++line_;
      } else if (text_[at_] == '\n') {
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
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }

  void scan() {
    Token token;
    token.begin = at_;
    token.line = line_;
    token.first = first_;
    std::size_t end = at_ + 1;
    const char c = text_[at_];
    if (starts_word(c)) {
      token.kind = Token::Kind::identifier;
      while (in_word(at(end))) ++end;
    } else if (is_digit(c) || (c == '.' && is_digit(at(end)))) {
      token.kind = Token::Kind::number;
      while (in_word(at(end)) || at(end) == '.' || exponent_sign(end)) ++end;
    } else if (c == '"' || c == '\'') {
      token.kind = scan_string(c, end);
    } else if (c == ':' && at(end) == ':') {
      ++end;
    }
    if (c == '#' && first_) preprocessor_ = true;
    token.preprocessor = preprocessor_;
    token.text = text_.substr(at_, end - at_);
    tokens_.push_back(token);
    first_ = false;
    at_ = end;
  }

  bool exponent_sign(std::size_t i) const {
    if (at(i) != '+' && at(i) != '-') return false;
    const bool hexadecimal = at(at_) == '0' && (at(at_ + 1) == 'x' || at(at_ + 1) == 'X');
    return !hexadecimal && (at(i - 1) == 'e' || at(i - 1) == 'E');
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
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool first_ = true;
  bool preprocessor_ = false;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text) {
  return Scanner(text).run();
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
