#include "host/text/plain_tokens.h"

#include <algorithm>
#include <cctype>

#include "host/language/tokens.h"

namespace shadertwin {

bool is_identifier(const std::string& token) {
  return !token.empty() && (std::isalpha(static_cast<unsigned char>(token[0])) != 0 || token[0] == '_');
}

const std::string& text_at(const std::vector<PlainToken>& tokens, int i) {
  static const std::string none;
  return i >= 0 && i < static_cast<int>(tokens.size()) ? tokens[static_cast<std::size_t>(i)].text : none;
}

std::vector<PlainToken> split_tokens(std::string_view plain) {
  std::vector<PlainToken> tokens;
  std::size_t past_end = 0;  // of the last directive
  for (const Token& token : tokenize(plain, {.strings = false})) {
    if (token.begin < past_end) continue;
    std::string_view text = token.text;
    if (token.first && token.is("#")) {
      past_end = std::min(plain.find('\n', token.begin), plain.size());
      text = plain.substr(token.begin, past_end - token.begin);
    }
    tokens.push_back({std::string(text), token.line, token.space_before});
  }
  return tokens;
}

std::string one_token_a_line(const std::vector<PlainToken>& tokens) {
  std::string text;
  for (const PlainToken& token : tokens) text += token.text + '\n';
  return text;
}

}  // namespace shadertwin
