#include "host/language/entry_points.h"

#include <algorithm>

namespace shadertwin {

namespace {

// `void main() {` or `void main(void) {`; i is at main.
bool defines_main(const std::vector<Token>& tokens, std::size_t i) {
  if (i + 3 >= tokens.size() || !tokens[i + 1].is("(")) return false;
  std::size_t after = i + 2;
  if (tokens[after].is("void")) ++after;
  return after + 1 < tokens.size() && tokens[after].is(")") && tokens[after + 1].is("{");
}

// Whether what stands in the parentheses behind token i has a comma.
bool has_two_parameters(const std::vector<Token>& tokens, std::size_t i) {
  for (std::size_t k = i + 1; k < tokens.size() && !tokens[k].is(")"); ++k)
    if (tokens[k].is(",")) return true;
  return false;
}

}  // namespace

std::size_t body_of_function(const std::vector<Token>& tokens, std::size_t name) {
  const auto is = [&](std::size_t i, std::string_view text) {
    return i < tokens.size() && tokens[i].is(text);
  };
  if (!is(name + 1, "(")) return tokens.size();
  std::size_t close = name + 2;
  while (close < tokens.size() && !tokens[close].is(")")) ++close;
  return is(close + 1, "{") ? close + 1 : tokens.size();
}

EntryPoints find_entry_points(const std::vector<Token>& tokens) {
  EntryPoints found;
  bool of_sample = false;
  bool of_time = false;
  int depth = 0;  // of braces and parentheses
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.preprocessor) continue;
    if (token.is("{") || token.is("(")) ++depth;
    if (token.is("}") || token.is(")")) depth = std::max(depth - 1, 0);
    if (token.kind != Token::Kind::identifier) continue;
    if (token.is("out") && depth == 0 && found.output_line == 0) found.output_line = token.line;
    // Functions can't be nested, so they are found behind a brace that is missing, too: the compiler tells
    // where.
    const bool is_function = i > 0 && i + 1 < tokens.size() && tokens[i + 1].is("(") &&
                             tokens[i - 1].kind == Token::Kind::identifier && !tokens[i - 1].is("return");
    if (!is_function) continue;
    if (token.is("main") && defines_main(tokens, i)) found.main = true;
    if (token.text.size() > 4 && token.text.starts_with("main")) found.functions.emplace(token.text);
    if (token.is("mainImage") && i + 2 < tokens.size() && tokens[i + 2].is("inout"))
      found.image_is_inout = true;
    // The site calls the new form, also where the old one stands beside it.
    if (token.is("mainSound") && tokens[i - 1].is("vec2"))
      (has_two_parameters(tokens, i) ? of_sample : of_time) = true;
  }
  found.sound_of_time = of_time && !of_sample;
  return found;
}

}  // namespace shadertwin
