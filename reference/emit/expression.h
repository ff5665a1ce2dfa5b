// A C++ expression, and what its users would otherwise have to read out of its text.
#pragma once

#include <string>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

struct Expression {
  std::string text;  // empty: the statements in front of it have said it all
  Binding binding = Binding::primary;
  char sign = '\0';         // the prefix operator that the text begins with: -(-x) must not become --x
  bool is_literal = false;  // a constant that is written out, not named

  bool is_empty() const { return text.empty(); }
  std::string at_least(Binding needed) const { return binding < needed ? "(" + text + ")" : text; }
};

inline Expression call_of(const std::string& function, const std::string& arguments) {
  return {function + "(" + arguments + ")", Binding::postfix};
}

constexpr Binding above(Binding binding) {
  return static_cast<Binding>(static_cast<int>(binding) + 1);
}

}  // namespace shadertwin::emit
