// Where a function's local variables are declared. The tree keeps uses but no declarations.
#pragma once

#include <map>
#include <vector>

#include "reference/emit/program.h"

namespace shadertwin::emit {

// One block of statements (`{ ... }`, or the wrapper that glslang puts around a for loop and its
// initialiser).
using Block = glslang::TIntermAggregate;

class Placement {
 public:
  Placement(const Program& program, const Function& function);

  // The variables to declare before statement `index` of `block`, in the order of the text. One whose first
  // use is an assignment there can be declared by it.
  const std::vector<const glslang::TIntermSymbol*>& declared_at(const Block& block, int index) const;

 private:
  std::map<std::pair<const Block*, int>, std::vector<const glslang::TIntermSymbol*>> places_;
};

// Whether a sequence among the statements of a block is a list of declarations, `float a = 1.0, b = 2.0;`,
// whose names belong to the block around it.
bool is_declaration_list(const SyntaxTree& tree, const TIntermNode& node);

// Whether a sequence is the wrapper around a for loop and its initialiser.
bool is_for_loop(const SyntaxTree& tree, const Block& block);

}  // namespace shadertwin::emit
