// Which declaration each name of a shader means, found from the tokens alone.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/tokens.h"

namespace shadertwin::emit {

class Declarations {
 public:
  explicit Declarations(const std::vector<Token>& tokens);

  // The token that declares the variable which token `use` names (itself, if it is the declaration), or -1
  // when the token names no variable that is declared in the text.
  int declaration_of(int use) const { return in_range(use) ? declaration_[use] : -1; }
  bool is_declaration(int token) const { return token >= 0 && declaration_of(token) == token; }
  // Whether the variable that token `declaration` declares is const.
  bool is_const(int declaration) const { return in_range(declaration) && is_const_[declaration]; }

 private:
  bool in_range(int token) const { return token >= 0 && token < static_cast<int>(declaration_.size()); }

  std::vector<int> declaration_;
  std::vector<bool> is_const_;
};

}  // namespace shadertwin::emit
