#include "host/text/plain_tokens.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "host/language/tokens.h"

namespace shadertwin::emit {

bool is_identifier(const std::string& token) {
  return !token.empty() && (std::isalpha(static_cast<unsigned char>(token[0])) != 0 || token[0] == '_');
}

std::vector<Token> split_tokens(const std::string& preprocessed) {
  std::vector<Token> tokens;
  int shift = 0;             // from physical lines to what #line makes of them
  std::size_t past_end = 0;  // of the last directive
  for (const shadertwin::Token& token : tokenize(preprocessed, {.strings = false})) {
    if (token.begin < past_end) continue;
    std::string text(token.text);
    if (token.first && token.is("#")) {
      past_end = std::min(preprocessed.find('\n', token.begin), preprocessed.size());
      text = preprocessed.substr(token.begin, past_end - token.begin);
      if (text.starts_with("#line")) {
        shift = std::atoi(text.c_str() + 5) - (token.line + 1);  // it numbers the line behind it
        continue;
      }
    }
    tokens.push_back({std::move(text), token.line + shift});
  }
  return tokens;
}

std::string one_token_a_line(const std::vector<Token>& tokens) {
  std::string text;
  for (const Token& token : tokens) text += token.text + '\n';
  return text;
}

}  // namespace shadertwin::emit
