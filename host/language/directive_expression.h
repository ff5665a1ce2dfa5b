// The integer expressions of #if, #elif and #line.
#pragma once

#include <cstdint>
#include <string>

#include "host/language/preprocessing_token.h"

namespace shadertwin {

struct DirectiveExpression {
  std::int32_t value = 0;
  bool valid = false;  // else an error has been told
};

struct ExpressionRules {
  bool is_signed = false;  // whether numbers end at 2^31 - 1 instead of 2^32 - 1
  std::string name_error;  // what is told, behind the name, of a name that is left after expansion
};

// Parses and evaluates as browsers do: 32 bits that wrap around, >> fills with zeros, and what && and ||
// don't need may hold undefined names, divisions by zero and shifts beyond 0 to 31. Nesting is limited as in
// ANGLE, whose stack holds 9999 symbols. token: the first token; then, the first one behind the expression.
DirectiveExpression evaluate(TokenSource& source, PreprocessingToken& token, PreprocessingState& state,
                             const ExpressionRules& rules);

}  // namespace shadertwin
