// Where the operands of an operator and the arguments of a call begin and end: glslang's tree knows the
// token of an operation, not those of its parts.
#pragma once

#include <cstddef>
#include <vector>

#include "host/text/plain_tokens.h"

namespace shadertwin {

// Numbers of tokens, both of them inside.
struct TokenRange {
  int first = -1;
  int last = -1;

  int size() const { return last - first + 1; }
};

// The bracket that closes the one at `open`, or opens the one at `close`: (), [] or {}. The last or first
// token of the text if there is none.
int closing_bracket(const std::vector<PlainToken>& tokens, int open);
int opening_bracket(const std::vector<PlainToken>& tokens, int close);

// The ( or [ that opens around a token of an expression; -1 if none does.
int enclosing_bracket(const std::vector<PlainToken>& tokens, int token);

// Of `/`, `%` and the assignments /= and %=.
TokenRange left_operand(const std::vector<PlainToken>& tokens, int operation);
TokenRange right_operand(const std::vector<PlainToken>& tokens, int operation);

// The argument that token `inside` belongs to, of the call whose parenthesis opens at `open`.
TokenRange argument_around(const std::vector<PlainToken>& tokens, int open, int inside);
// The first `count` arguments of that call.
std::vector<TokenRange> arguments_of(const std::vector<PlainToken>& tokens, int open, std::size_t count);

// The name of a called function by the token that the tree has for the call: the name itself, or one of the
// parentheses behind it.
int name_of_call(const std::vector<PlainToken>& tokens, int token);

}  // namespace shadertwin
