#include "host/text/plain_tokens.h"

#include <array>
#include <cctype>
#include <string_view>

namespace shadertwin::emit {
namespace {

bool is_name_start(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_name_part(char c) {
  return is_name_start(c) || is_digit(c);
}

// Longest first.
constexpr std::array<std::string_view, 21> long_operators = {
    "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",
    "||",  "^^",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};

std::size_t number_end(const std::string& text, std::size_t at) {
  const bool hexadecimal = text.compare(at, 2, "0x") == 0 || text.compare(at, 2, "0X") == 0;
  std::size_t end = at;
  while (end < text.size()) {
    const char c = text[end];
    const bool exponent_sign =
        (c == '+' || c == '-') && !hexadecimal && end > at && (text[end - 1] == 'e' || text[end - 1] == 'E');
    if (!is_name_part(c) && c != '.' && !exponent_sign) break;
    ++end;
  }
  return end;
}

std::size_t token_end(const std::string& text, std::size_t at) {
  if (is_name_start(text[at])) {
    std::size_t end = at;
    while (end < text.size() && is_name_part(text[end])) ++end;
    return end;
  }
  if (is_digit(text[at]) || (text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1])))
    return number_end(text, at);
  for (const std::string_view op : long_operators) {
    if (text.compare(at, op.size(), op) == 0) return at + op.size();
  }
  return at + 1;
}

}  // namespace

bool is_identifier(const std::string& token) {
  return !token.empty() && is_name_start(token[0]);
}

std::vector<Token> split_tokens(const std::string& preprocessed) {
  std::vector<Token> tokens;
  int line = 1;
  bool line_is_empty = true;
  std::size_t at = 0;
  while (at < preprocessed.size()) {
    const char c = preprocessed[at];
    if (c == '\n') {
      ++line;
      ++at;
      line_is_empty = true;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
    } else if (c == '#' && line_is_empty) {
      const std::size_t end = std::min(preprocessed.find('\n', at), preprocessed.size());
      const std::string directive = preprocessed.substr(at, end - at);
      if (directive.rfind("#line", 0) == 0) {
        line = std::atoi(directive.c_str() + 5) - 1;  // the newline that follows counts up
      } else {
        tokens.push_back({directive, line});
      }
      at = end;
    } else {
      const std::size_t end = token_end(preprocessed, at);
      tokens.push_back({preprocessed.substr(at, end - at), line});
      at = end;
      line_is_empty = false;
    }
  }
  return tokens;
}

std::string one_token_a_line(const std::vector<Token>& tokens) {
  std::string text;
  for (const Token& token : tokens) text += token.text + '\n';
  return text;
}

}  // namespace shadertwin::emit
