#include "host/text/switch_labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace shadertwin {
namespace {

// The bracket that closes the one at `open`; the end of the tokens if there is none.
std::size_t closing(const std::vector<PlainToken>& tokens, std::size_t open) {
  const std::string& opener = tokens[open].text;
  const std::string closer = opener == "(" ? ")" : "}";
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    if (tokens[i].text == opener) ++depth;
    if (tokens[i].text == closer && --depth == 0) return i;
  }
  return tokens.size();
}

// Whether statements compute nothing and jump nowhere.
bool do_nothing(const std::vector<PlainToken>& tokens, std::size_t first, std::size_t end) {
  static constexpr std::array<std::string_view, 9> harmless = {";", ",", ".", "[", "]", "{", "}", "+", "-"};
  static constexpr std::array<std::string_view, 12> acting = {"break", "continue", "return", "discard",
                                                              "if",    "else",     "for",    "while",
                                                              "do",    "switch",   "case",   "default"};
  return std::all_of(tokens.begin() + static_cast<std::ptrdiff_t>(first),
                     tokens.begin() + static_cast<std::ptrdiff_t>(end), [](const PlainToken& token) {
                       const auto c = static_cast<unsigned char>(token.text[0]);
                       if (std::isalnum(c) == 0 && c != '_')
                         return std::find(harmless.begin(), harmless.end(), token.text) != harmless.end();
                       return std::find(acting.begin(), acting.end(), token.text) == acting.end();
                     });
}

// The colon of the label at `label`: in `case a ? 1 : 2:` the second one.
std::size_t colon_of(const std::vector<PlainToken>& tokens, std::size_t label) {
  int choices = 0;
  for (std::size_t i = label; i < tokens.size(); ++i) {
    if (tokens[i].text == "?") ++choices;
    if (tokens[i].text == ":" && choices-- == 0) return i;
  }
  return tokens.size();
}

}  // namespace

std::vector<PlainToken> with_kept_labels(std::vector<PlainToken> tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text != "switch" || tokens[i + 1].text != "(") continue;
    const std::size_t open = closing(tokens, i + 1) + 1;
    if (open >= tokens.size() || tokens[open].text != "{") continue;
    const std::size_t close = closing(tokens, open);
    std::size_t last = tokens.size();
    for (std::size_t at = open + 1; at < close; ++at) {
      if (tokens[at].text == "{")
        at = closing(tokens, at);
      else if (tokens[at].text == "case" || tokens[at].text == "default")
        last = at;
    }
    const std::size_t colon = colon_of(tokens, last);
    if (close < tokens.size() && colon + 1 < close && do_nothing(tokens, colon + 1, close))
      tokens[colon].text = ": break;";
  }
  return tokens;
}

}  // namespace shadertwin
