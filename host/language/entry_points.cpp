#include "host/language/entry_points.h"

#include <map>
#include <string_view>

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

// Whether the macro that token i is the name of has that name in its text, too.
bool names_itself(const std::vector<Token>& tokens, std::size_t i) {
  for (std::size_t k = i + 1; k < tokens.size() && tokens[k].preprocessor && !tokens[k].first; ++k)
    if (tokens[k].is(tokens[i].text)) return true;
  return false;
}

// Whether token i stands where a statement or a global declaration may begin. Macros may open parentheses and
// braces that the text closes, so counting them tells nothing.
bool begins_declaration(const std::vector<Token>& tokens, std::size_t i) {
  if (i == 0 || tokens[i - 1].preprocessor) return true;
  const Token& before = tokens[i - 1];
  return before.is(";") || before.is("}") || before.is(")");
}

bool is_entry(std::string_view name) {
  return name == "mainImage" || name == "mainSound" || name == "mainCubemap" || name == "mainVR";
}

// Macros that are another name for an entry point: `#define M mainSound`.
std::map<std::string_view, std::string_view> other_names(const std::vector<Token>& tokens) {
  std::map<std::string_view, std::string_view> names;
  for (std::size_t i = 3; i < tokens.size(); ++i) {
    const bool last = i + 1 == tokens.size() || !tokens[i + 1].preprocessor || tokens[i + 1].first;
    if (last && is_entry(tokens[i].text) && tokens[i - 2].is("define") && tokens[i - 3].is("#"))
      names[tokens[i - 1].text] = tokens[i].text;
  }
  return names;
}

}  // namespace

EntryPoints find_entry_points(const std::vector<Token>& written) {
  std::vector<Token> tokens = written;
  if (const auto names = other_names(tokens); !names.empty())
    for (Token& token : tokens)
      if (const auto name = names.find(token.text); !token.preprocessor && name != names.end())
        token.text = name->second;
  EntryPoints found;
  bool of_sample = false;
  bool of_time = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.is("out") && !token.preprocessor && begins_declaration(tokens, i)) found.output = true;
    if (token.kind != Token::Kind::identifier) continue;
    if (token.is("main") && defines_main(tokens, i)) found.main = true;
    if (token.is("mainImage")) {
      found.image = true;
      if (i + 2 < tokens.size() && tokens[i + 1].is("(") && tokens[i + 2].is("inout"))
        found.image_is_inout = true;
      if (i >= 2 && tokens[i - 1].is("define") && tokens[i - 2].is("#"))
        (names_itself(tokens, i) ? found.image_names_itself : found.image_is_macro) = true;
    }
    if (token.is("mainCubemap")) found.cubemap = true;
    if (token.is("mainVR")) found.vr = true;
    if (token.is("mainSound")) {
      found.sound = true;
      // The site calls the new form, also where the old one stands beside it.
      if (i >= 1 && tokens[i - 1].is("vec2")) (has_two_parameters(tokens, i) ? of_sample : of_time) = true;
    }
  }
  found.sound_of_time = of_time && !of_sample;
  return found;
}

}  // namespace shadertwin
