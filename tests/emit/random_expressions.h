// Random expressions.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/emit/random_values.h"

namespace shadertwin::random_program {

class RandomExpressions : public RandomValues {
 protected:
  explicit RandomExpressions(std::uint32_t seed) : RandomValues(seed) {}

  // `depth`: how far expressions may nest. `effects`: whether it may write the reserved variables.
  std::string expression(const Type& type, int depth, bool effects);
  // Two operands with a sign between them, effects in at most one.
  std::string pair(const Type& a, const char* sign, const Type& b, int depth, bool effects);
  std::string real_value(const Type& type, int depth, bool effects);
  // Arguments of a vector's constructor: smaller vectors and scalars, of any base.
  std::string joined(const Type& type, int depth, bool effects);
  std::string whole_value(const Type& type, int depth, bool effects);
  std::string truth_value(const Type& type, int depth, bool effects);
  std::string matrix(const Type& type, int depth, bool effects);
  // Writes a reserved variable and gives a value.
  std::string effect(const Type& type, int depth);
  // A call that gives that type; empty if there is none.
  std::string call(const Type& type, int depth, bool effects);
  std::string call_of(const Function& function, int depth, bool effects);
  // A whole expression, with some variables put aside for its effects.
  std::string full(const Type& type, int depth);
  // Globals that a function may write are put aside whenever one may be called.
  void reserve();

  std::vector<Function> functions_;
  bool in_expression_ = false;
  bool writes_ = false;
  int cost_ = 0;    // statements run so far
  int rounds_ = 1;  // how often a statement runs here
};

}  // namespace shadertwin::random_program
