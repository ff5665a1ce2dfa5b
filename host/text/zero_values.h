// What zero of a type looks like in GLSL, and what constant expressions of integers come to, from the tokens
// of a shader alone.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/text/declarations.h"
#include "host/text/plain_tokens.h"

namespace shadertwin {

class ZeroValues {
 public:
  ZeroValues(const std::vector<PlainToken>& tokens, const Declarations& declarations);

  // `vec3(0)`, `Ray(vec3(0), float[2](0.0, 0.0))`: empty if the type has no such constructor, or one that
  // would be too long to write.
  std::string of(const Variable& variable) const;
  std::string of_result(const FunctionBody& function) const;
  // Of one element of an array; empty if the variable is none.
  std::string of_element(const Variable& variable) const;

  // The value of a constant integer expression from token `first` up to `end`, if it is one of a simple kind.
  std::optional<int> constant(int first, int end) const;
  // How many elements an array has that a variable of this name declares.
  std::optional<int> array_size(const Variable& variable) const;
  // The variable that a token declares.
  const Variable* variable(int declaration) const;

 private:
  struct Member {
    int type = -1;
    int type_end = -1;
    int name = -1;
    int end = -1;
  };
  struct Structure {
    int name = -1;
    std::vector<Member> members;
  };
  struct Text {
    std::string text;
    int values = 0;  // how many constants stand in it
  };

  const std::string& text(int token) const;
  void read_structure(int keyword);
  int skip_brackets(int token) const;
  Text plain(int type) const;
  Text sized(int type, int first, int end) const;
  Text whole(int type, int type_end, int name, int end) const;

  const std::vector<PlainToken>& tokens_;
  const Declarations& declarations_;
  std::vector<Structure> structures_;
  std::map<int, const Variable*> variables_;
};

}  // namespace shadertwin
