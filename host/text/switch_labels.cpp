#include "host/text/switch_labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "host/text/operands.h"

namespace shadertwin {
namespace {

// Whether statements compute nothing and jump nowhere.
bool do_nothing(const std::vector<PlainToken>& tokens, int first, int end) {
  static constexpr std::array<std::string_view, 9> harmless = {";", ",", ".", "[", "]", "{", "}", "+", "-"};
  static constexpr std::array<std::string_view, 12> acting = {"break", "continue", "return", "discard",
                                                              "if",    "else",     "for",    "while",
                                                              "do",    "switch",   "case",   "default"};
  return std::all_of(tokens.begin() + first, tokens.begin() + end, [](const PlainToken& token) {
    const auto c = static_cast<unsigned char>(token.text[0]);
    if (std::isalnum(c) == 0 && c != '_')
      return std::find(harmless.begin(), harmless.end(), token.text) != harmless.end();
    return std::find(acting.begin(), acting.end(), token.text) == acting.end();
  });
}

// The colon of the label at `label`: in `case a ? 1 : 2:` the second one.
int colon_of(const std::vector<PlainToken>& tokens, int label) {
  int choices = 0;
  int i = label;
  for (; !text_at(tokens, i).empty(); ++i) {
    if (text_at(tokens, i) == "?") ++choices;
    if (text_at(tokens, i) == ":" && choices-- == 0) break;
  }
  return i;
}

}  // namespace

std::vector<PlainToken> with_kept_labels(std::vector<PlainToken> tokens) {
  for (int i = 0; i + 1 < static_cast<int>(tokens.size()); ++i) {
    if (text_at(tokens, i) != "switch" || text_at(tokens, i + 1) != "(") continue;
    const int open = closing_bracket(tokens, i + 1) + 1;
    if (text_at(tokens, open) != "{") continue;
    const int close = closing_bracket(tokens, open);
    int last = -1;
    for (int at = open + 1; at < close; ++at) {
      if (text_at(tokens, at) == "{")
        at = closing_bracket(tokens, at);
      else if (text_at(tokens, at) == "case" || text_at(tokens, at) == "default")
        last = at;
    }
    const int colon = last < 0 ? close : colon_of(tokens, last);
    if (colon + 1 < close && do_nothing(tokens, colon + 1, close))
      tokens[static_cast<std::size_t>(colon)].text = ": break;";
  }
  return tokens;
}

}  // namespace shadertwin
