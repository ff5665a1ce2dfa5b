// What a shader consists of, and what its functions do to the variables they share.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin::emit {

using SymbolId = long long;

// The variables that an expression or a function reads and writes.
struct Effects {
  std::set<SymbolId> reads;
  std::set<SymbolId> writes;

  bool writes_any() const { return !writes.empty(); }
  void add(const Effects& other);
  // Whether the order in which the two are evaluated can be seen.
  bool conflicts_with(const Effects& other) const;
};

struct Parameter {
  const glslang::TIntermSymbol* symbol = nullptr;
  bool is_out = false;  // out or inout
  bool is_inout = false;
};

struct Function {
  std::string mangled_name;  // with the types of its parameters
  std::string name;
  const glslang::TIntermAggregate* definition = nullptr;
  const glslang::TIntermAggregate* body = nullptr;  // null for a body without statements
  std::vector<Parameter> parameters;
  Effects globals;                 // with those of the functions that it calls
  std::set<std::string> calls;     // the names of the functions that it calls itself
  std::set<std::string> builtins;  // and of the built-in ones
  bool discards = false;           // itself
};

class Program {
 public:
  // Throws Error(shader) for recursion and for a function that is declared and called but not defined.
  explicit Program(const SyntaxTree& tree);

  const SyntaxTree& tree() const { return tree_; }
  const std::vector<Function>& functions() const { return functions_; }  // in the order of the text
  const Function& function(const glslang::TIntermAggregate& call) const;

  // Global variables, constants, uniforms, inputs and outputs in the order of the text.
  const std::vector<const glslang::TIntermSymbol*>& globals() const { return globals_; }
  bool is_global(SymbolId id) const { return global_ids_.count(id) != 0; }
  // `symbol = value` for every global variable that has an initialiser, in the order of the text.
  const std::vector<const glslang::TIntermBinary*>& initialisers() const { return initialisers_; }

  // Writes that no variable shows (discard) are told by a write of this.
  static constexpr SymbolId control_flow = -1;

  const Effects& effects(const TIntermNode& node) const;

  bool uses_derivatives() const { return uses_derivatives_; }
  bool uses_implicit_lod() const { return uses_implicit_lod_; }
  bool uses_discard() const;

 private:
  void collect(const TIntermNode& node);
  void add_function(const glslang::TIntermAggregate& definition);
  void resolve_calls();

  const SyntaxTree& tree_;
  std::vector<Function> functions_;
  std::map<std::string, int> function_index_;
  std::vector<const glslang::TIntermSymbol*> globals_;
  std::set<SymbolId> global_ids_;
  std::vector<const glslang::TIntermBinary*> initialisers_;
  bool uses_derivatives_ = false;
  bool uses_implicit_lod_ = false;
  mutable std::unordered_map<const TIntermNode*, Effects> effects_;
};

// The variable at the bottom of an l-value: `a` for a.b[i].xy. Null if there is none.
const glslang::TIntermSymbol* base_symbol(const glslang::TIntermTyped& lvalue);

// The qualifier list of a call says which arguments come back.
bool is_out(glslang::TStorageQualifier qualifier);

}  // namespace shadertwin::emit
