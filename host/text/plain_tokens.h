// The tokens of a shader without macros, and where each of them stands.
//
// The parser is fed one token a line, so that the line number which it keeps for every node of its tree is
// the number of the token the node stands for. That gives back what the tree drops: which declaration a name
// means, the names of constants, and the user's own line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/language/preprocessor.h"

namespace shadertwin {

// Splits what render() writes. A directive (#version, #extension, #pragma) is one token.
std::vector<PlainToken> split_tokens(std::string_view plain);

// The tokens, one a line: token i stands in line i + 1.
std::string one_token_a_line(const std::vector<PlainToken>& tokens);

bool is_identifier(const std::string& token);

// The text of token `i`; empty if there is no such token.
const std::string& text_at(const std::vector<PlainToken>& tokens, int i);

}  // namespace shadertwin
