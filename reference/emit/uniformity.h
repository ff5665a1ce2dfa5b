// What is the same for all pixels that run side by side: values, and the way that control takes.
#pragma once

#include <map>
#include <set>

#include "reference/emit/placement.h"
#include "reference/emit/program.h"

namespace shadertwin::emit {

// A packet runs one statement for all of its pixels. Where control diverges, those that took the other way
// are masked out: a region is a part of a function that the same pixels run. Everything starts out as
// uniform; what contradicts that is varying or divergent, until nothing more follows.
class Uniformity {
 public:
  explicit Uniformity(const Program& program);

  // Whether a variable, or the value of an expression, may differ between pixels. Structures always may, and
  // arrays that are not constant.
  bool varies(const glslang::TIntermSymbol& symbol) const;
  bool varies(const glslang::TIntermTyped& node) const;
  // The same for what a function returns.
  bool varies(const Function& function) const { return varying_results_.count(&function) != 0; }

  // Whether pixels may take different ways at this `if`, loop, `switch`, `?:`, `&&` or `||`.
  bool diverges(const TIntermNode& node) const { return divergent_.count(&node) != 0; }
  // Whether some pixels skip what is left of this loop's body while others do not.
  bool diverges_in_body(const TIntermNode& loop) const { return divergent_bodies_.count(&loop) != 0; }
  // Whether some pixels return from the function before others.
  bool diverges_at_return(const Function& function) const { return divergent_returns_.count(&function) != 0; }
  // Whether some of the pixels that can see the assigned variable take no part in this assignment.
  bool is_masked(const TIntermNode& assignment) const { return masked_.count(&assignment) != 0; }
  // Whether pixels may end, or leave a loop or the function, in this statement.
  bool may_jump(const TIntermNode& statement) const;
  // Whether the function or one that it calls discards.
  bool discards(const Function& function) const { return discarding_.count(&function) != 0; }

 private:
  friend class UniformityPass;

  const Program& program_;
  std::set<SymbolId> varying_symbols_;
  std::set<const Function*> varying_results_;
  std::set<const Function*> divergent_returns_;
  std::set<const Function*> discarding_;
  std::set<const TIntermNode*> divergent_;
  std::set<const TIntermNode*> divergent_bodies_;
  std::set<const TIntermNode*> masked_;
};

// Whether an operand is worth a branch of its own, so that pixels that do not need it can skip it.
bool is_costly(const TIntermNode& node);

}  // namespace shadertwin::emit
