// The tokens of a shader after preprocessing, and where each of them came from.
//
// The parser is fed one token a line, so that the line number which it keeps for every node of its tree is
// the number of the token the node stands for. That gives back what the tree drops: which declaration a name
// means, the names of constants, and the user's own line for text that a macro made.
#pragma once

#include <string>
#include <vector>

namespace shadertwin::emit {

struct Token {
  std::string text;
  int line = 0;  // from 1, in the text before preprocessing
};

// Splits preprocessed text. A directive that the preprocessor leaves in place (#version, #extension, #pragma)
// is one token; #line is obeyed and dropped.
std::vector<Token> split_tokens(const std::string& preprocessed);

// The tokens, one a line: token i stands in line i + 1.
std::string one_token_a_line(const std::vector<Token>& tokens);

bool is_identifier(const std::string& token);

}  // namespace shadertwin::emit
