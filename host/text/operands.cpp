#include "host/text/operands.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace shadertwin {
namespace {

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<std::string_view, N>& list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

bool is_opening(const std::string& text) {
  return text == "(" || text == "[" || text == "{";
}
bool is_closing(const std::string& text) {
  return text == ")" || text == "]" || text == "}";
}

// A word in front of a statement or of what follows it, and so the end of no operand.
bool is_statement_word(const std::string& text) {
  static constexpr std::array<std::string_view, 8> words = {"return", "case", "else",   "do",
                                                            "if",     "for",  "switch", "while"};
  return is_one_of(text, words);
}

bool ends_operand(const std::string& text) {
  if (text.empty()) return false;
  const char c = text[0];
  const bool word = is_identifier(text) || (c >= '0' && c <= '9') || (c == '.' && text.size() > 1);
  return word ? !is_statement_word(text) : text == ")" || text == "]" || text == "++" || text == "--";
}

bool is_prefix(const std::string& text) {
  static constexpr std::array<std::string_view, 6> prefixes = {"+", "-", "!", "~", "++", "--"};
  return is_one_of(text, prefixes);
}

// Where the operand that ends at `last` begins, without what stands in front of it as a prefix.
int primary_start(const std::vector<PlainToken>& tokens, int last) {
  int i = last;
  while (text_at(tokens, i) == "++" || text_at(tokens, i) == "--") --i;
  for (;;) {
    const std::string& text = text_at(tokens, i);
    if (text == ")" || text == "]") {
      i = opening_bracket(tokens, i);
      const std::string& before = text_at(tokens, i - 1);
      const bool of_something = ends_operand(before) && before != "++" && before != "--";
      if (!of_something) return i;
      --i;
    } else if (text_at(tokens, i - 1) == ".") {
      i -= 2;
    } else {
      return i;
    }
  }
}

bool is_product(const std::string& text) {
  return text == "*" || text == "/" || text == "%";
}

int with_prefixes(const std::vector<PlainToken>& tokens, int first) {
  while (is_prefix(text_at(tokens, first - 1))) {
    const std::string& prefix = text_at(tokens, first - 1);
    if ((prefix == "+" || prefix == "-") && ends_operand(text_at(tokens, first - 2))) break;
    --first;
  }
  return first;
}

}  // namespace

int closing_bracket(const std::vector<PlainToken>& tokens, int open) {
  const int size = static_cast<int>(tokens.size());
  int depth = 0;
  for (int i = open; i < size; ++i) {
    if (is_opening(text_at(tokens, i))) ++depth;
    if (is_closing(text_at(tokens, i)) && --depth == 0) return i;
  }
  return size - 1;
}

int opening_bracket(const std::vector<PlainToken>& tokens, int close) {
  int depth = 0;
  for (int i = close; i >= 0; --i) {
    if (is_closing(text_at(tokens, i))) ++depth;
    if (is_opening(text_at(tokens, i)) && --depth == 0) return i;
  }
  return 0;
}

TokenRange left_operand(const std::vector<PlainToken>& tokens, int operation) {
  int first = primary_start(tokens, operation - 1);
  if (!is_product(text_at(tokens, operation))) return {first, operation - 1};
  first = with_prefixes(tokens, first);
  while (is_product(text_at(tokens, first - 1)))
    first = with_prefixes(tokens, primary_start(tokens, first - 2));
  return {first, operation - 1};
}

TokenRange right_operand(const std::vector<PlainToken>& tokens, int operation) {
  int last = operation + 1;
  if (!is_product(text_at(tokens, operation))) {  // of an assignment: all up to what ends the expression
    int choices = 0;
    for (int i = last; i < static_cast<int>(tokens.size()); ++i) {
      const std::string& text = text_at(tokens, i);
      if (is_opening(text)) {
        i = closing_bracket(tokens, i);
        continue;
      }
      if (text == "?") ++choices;
      if (is_closing(text) || text == "," || text == ";" || (text == ":" && choices-- == 0))
        return {operation + 1, i - 1};
    }
    return {operation + 1, static_cast<int>(tokens.size()) - 1};
  }
  while (is_prefix(text_at(tokens, last))) ++last;
  if (text_at(tokens, last) == "(") last = closing_bracket(tokens, last);
  for (;;) {
    const std::string& next = text_at(tokens, last + 1);
    if (next == "(" || next == "[")
      last = closing_bracket(tokens, last + 1);
    else if (next == ".")
      last += 2;
    else if (next == "++" || next == "--")
      ++last;
    else
      return {operation + 1, last};
  }
}

int enclosing_bracket(const std::vector<PlainToken>& tokens, int token) {
  for (int i = token - 1; i >= 0; --i) {
    const std::string& at = text_at(tokens, i);
    if (at == "(" || at == "[") return i;
    if (at == ")" || at == "]") i = opening_bracket(tokens, i);
    if (at == ";" || at == "{" || at == "}") break;
  }
  return -1;
}

TokenRange argument_around(const std::vector<PlainToken>& tokens, int open, int inside) {
  const int close = closing_bracket(tokens, open);
  int first = open + 1;
  for (int i = first; i < close; ++i) {
    const std::string& text = text_at(tokens, i);
    if (is_opening(text)) i = closing_bracket(tokens, i);
    if (text != ",") continue;
    if (i > inside) return {first, i - 1};
    first = i + 1;
  }
  return {first, close - 1};
}

std::vector<TokenRange> arguments_of(const std::vector<PlainToken>& tokens, int open, std::size_t count) {
  std::vector<TokenRange> arguments;
  int first = open + 1;
  while (arguments.size() < count) {
    arguments.push_back(argument_around(tokens, open, first));
    first = arguments.back().last + 2;  // behind the comma
  }
  return arguments;
}

int name_of_call(const std::vector<PlainToken>& tokens, int token) {
  if (text_at(tokens, token) == ")") token = opening_bracket(tokens, token);
  return text_at(tokens, token) == "(" ? token - 1 : token;
}

}  // namespace shadertwin
