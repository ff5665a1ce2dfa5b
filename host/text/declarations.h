// Which declaration each name of a shader means, found from the tokens alone.
#pragma once

#include <string>
#include <vector>

#include "host/text/plain_tokens.h"

namespace shadertwin {

// A variable or parameter by its tokens.
struct Variable {
  enum class Place { global, parameter, local };
  Place place = Place::local;
  int name = -1;      // -1 for a parameter without one
  int type = -1;      // `float`, a structure's name, or `struct`
  int type_end = -1;  // past the type and the sizes behind it
  int end = -1;       // past the name and the sizes behind it: where an initialiser stands
  bool initialised = false;
  bool is_const = false;
  bool is_in = false;   // as `in` or `inout`
  bool is_out = false;  // as `out` or `inout`
  bool is_uniform = false;
};

// A function that has a body.
struct FunctionBody {
  int type = -1;      // of what it returns
  int type_end = -1;  // past the sizes behind it
  int name = -1;
  int open = -1;  // the braces
  int close = -1;
  std::size_t first_parameter = 0;  // in variables()
  std::size_t parameters = 0;
  bool returns_last = false;  // its last statement is a return
};

// `for (...)`, by the tokens of its header.
struct ForLoop {
  int open = -1;  // the parentheses
  int close = -1;
  int end = -1;  // past the loop
};

class Declarations {
 public:
  explicit Declarations(const std::vector<PlainToken>& tokens);

  // The token that declares the variable which token `use` names (itself, if it is the declaration), or -1
  // when the token names no variable that is declared in the text.
  int declaration_of(int use) const { return in_range(use) ? declaration_[use] : -1; }
  bool is_declaration(int token) const { return token >= 0 && declaration_of(token) == token; }
  // Whether the variable that token `declaration` declares is const.
  bool is_const(int declaration) const { return in_range(declaration) && is_const_[declaration]; }

  // In the order of the text.
  const std::vector<Variable>& variables() const { return variables_; }
  const std::vector<FunctionBody>& functions() const { return functions_; }
  const std::vector<ForLoop>& loops() const { return loops_; }

 private:
  bool in_range(int token) const { return token >= 0 && token < static_cast<int>(declaration_.size()); }

  std::vector<int> declaration_;
  std::vector<bool> is_const_;
  std::vector<Variable> variables_;
  std::vector<FunctionBody> functions_;
  std::vector<ForLoop> loops_;
};

}  // namespace shadertwin
