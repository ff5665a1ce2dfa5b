#include "host/language/preprocessor.h"

#include <algorithm>

#include "host/language/characters.h"
#include "host/language/directive_parser.h"
#include "host/language/macro_expander.h"
#include "host/language/source_reader.h"

namespace shadertwin {

namespace {

using Kind = PreprocessingToken::Kind;

constexpr std::size_t made_limit = 1'000'000;  // tokens in the result that macros made

// Whether a compiler would read two tokens as others if they touched.
bool would_join(std::string_view before, std::string_view after) {
  const char a = before.back();
  const char b = after.front();
  const bool number = is_digit(before[0]) || (before[0] == '.' && before.size() > 1);
  if (in_word(a) && in_word(b)) return true;
  if (number && (in_word(b) || b == '.')) return true;
  if (before == "." && is_digit(b)) return true;
  constexpr std::string_view operators = "+-*/%<>=!&|^:#";
  const bool exponent = number && (b == '+' || b == '-');
  return exponent ||
         (operators.find(a) != std::string_view::npos && operators.find(b) != std::string_view::npos);
}

}  // namespace

PlainText preprocess(std::string_view text, const PreprocessOptions& options) {
  PreprocessingState state;
  SourceReader reader(text, state);
  DirectiveParser parser(reader, state, options);
  MacroExpander expander(parser, parser.macros(), state, false);
  // The text's own tokens are no more than its characters.
  const std::size_t limit = text.size() + made_limit;
  for (PreprocessingToken token = expander.next(); !token.is(Kind::end); token = expander.next()) {
    if (token.is(Kind::invalid_number)) state.error(token.line, quoted(token) + " is no number");
    if (token.is(Kind::invalid_character))
      state.error(token.line, quoted(token) + " is no character of the language outside of comments");
    if (state.result.tokens.size() == limit) {
      state.exhaust(token.line, "macros make more than " + std::to_string(made_limit) + " tokens");
      break;
    }
    state.result.tokens.push_back({std::string(token.text), token.line, token.space_before});
  }
  return std::move(state.result);
}

std::string to_text(const PlainText& text, int line_count) {
  std::string result;
  int line = 1;
  const auto go_to = [&](int wanted) {
    wanted = std::min(wanted, line_count);
    if (wanted <= line) return false;
    result.append(static_cast<std::size_t>(wanted - line), '\n');
    line = wanted;
    return true;
  };
  auto directive = text.directives.begin();
  const auto write_directive = [&] {
    go_to(directive->line);
    result += directive++->text;
  };
  const PlainToken* previous = nullptr;
  for (const PlainToken& token : text.tokens) {
    while (directive != text.directives.end() && directive->line < token.line) write_directive();
    const bool fresh = go_to(token.line);
    if (!fresh && previous != nullptr && (token.space_before || would_join(previous->text, token.text)))
      result += ' ';
    result += token.text;
    previous = &token;
  }
  while (directive != text.directives.end()) write_directive();
  go_to(line_count);
  return result + '\n';
}

int count_lines(std::string_view text) {
  int lines = 1;
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == '\n' || (text[i] == '\r' && text[i + 1] != '\n')) ++lines;
  return lines;
}

}  // namespace shadertwin
