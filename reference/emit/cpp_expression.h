// GLSL expressions as C++.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/emit/cpp_context.h"
#include "reference/emit/operators.h"

namespace shadertwin::emit {

// What C++ can't say in one expression in GLSL's order is said by statements in front of it: the prelude.
class CppExpressions {
 public:
  // `names` holds what the function's temporaries must not be called.
  CppExpressions(CppContext& context, NameScope& names) : context_(context), names_(names) {}
  virtual ~CppExpressions() = default;
  CppExpressions(const CppExpressions&) = delete;
  CppExpressions& operator=(const CppExpressions&) = delete;

  void name_local(SymbolId id, const std::string& name) { locals_[id] = name; }
  const std::string& local(SymbolId id) const { return locals_.at(id); }

  // The expression's text; prelude() holds what has to stand before it. `wide`: for a variable that varies.
  std::string value(const glslang::TIntermTyped& node, bool wide = false);
  // The same for a place where no statement can stand in front, such as a loop's condition.
  std::string self_contained(const glslang::TIntermTyped& node);
  // An expression whose value nobody wants; empty if the prelude says it all.
  std::string statement(const glslang::TIntermTyped& node);
  // Both at once: for what stands behind a loop's second semicolon.
  std::string self_contained_statement(const glslang::TIntermTyped& node);
  // Empties the prelude.
  std::vector<std::string> take_prelude();

 protected:
  struct Text {
    std::string text;
    Binding binding = Binding::primary;

    std::string at_least(Binding needed) const { return binding < needed ? "(" + text + ")" : text; }
  };

  // A multi-component swizzle, composed: v.zyx.xy is {v, 2, 1}.
  struct Swizzle {
    const glslang::TIntermTyped* base = nullptr;
    std::vector<int> components;
  };

  // What packets (packet_expression.h) say in another way.
  virtual std::string type_of(const glslang::TIntermTyped& node) const;
  // Whether the value may differ between the pixels of a packet.
  virtual bool varies(const glslang::TIntermTyped& /*node*/) const { return false; }
  // `text` of an operand, as it has to be where the others vary.
  virtual Text widened(const glslang::TIntermTyped& /*node*/, Text text) const { return text; }
  // The same for an argument of a function with overloads: there C++ has to see the very type.
  virtual Text packed(const glslang::TIntermTyped& /*node*/, Text text) const { return text; }
  virtual Text logical(const glslang::TIntermBinary& node);
  virtual Text assignment(const glslang::TIntermBinary& node, bool wants_value);
  virtual Text increment(const glslang::TIntermUnary& node, bool wants_value);
  virtual Text selection(const glslang::TIntermSelection& node);
  virtual Text constructor(const glslang::TIntermAggregate& node);
  virtual Text builtin_call(const glslang::TIntermAggregate& node);
  virtual Text call(const glslang::TIntermAggregate& node, bool wants_value);

  Text expression(const glslang::TIntermTyped& node);
  Text symbol(const glslang::TIntermSymbol& node);
  Text binary(const glslang::TIntermBinary& node);
  Text arithmetic(const glslang::TIntermBinary& node);
  Text arithmetic(glslang::TOperator op, const glslang::TIntermTyped& left,
                  const glslang::TIntermTyped& right, const Text& left_text, const Text& right_text);
  // Whether `left / right` is a division of floats that a checking twin looks at.
  bool needs_division_check(glslang::TOperator op, const glslang::TIntermTyped& left,
                            const glslang::TIntermTyped& right) const;
  Text index(const glslang::TIntermBinary& node);
  Text component(const Swizzle& swizzle);
  Text unary(const glslang::TIntermUnary& node);
  Text conversion(const glslang::TIntermTyped& node, const glslang::TIntermTyped& operand);
  Text aggregate(const glslang::TIntermAggregate& node, bool wants_value);
  // A built-in that Mesa computes in another way because of its constant arguments; no text if it doesn't.
  Text special_case(const glslang::TIntermAggregate& node);
  Text comma(const glslang::TIntermAggregate& node, bool wants_value);

  static Swizzle swizzle_of(const glslang::TIntermTyped& node);
  bool can_pass_by_reference(const glslang::TIntermAggregate& call, std::size_t argument);
  // Evaluates operands from left to right, each into a temporary where C++ could choose another order.
  // `wide`: among operands that vary.
  std::vector<Text> in_order(const std::vector<const glslang::TIntermTyped*>& operands, bool wide = false);
  Text temporary(const glslang::TIntermTyped& node, const std::string& text);
  std::string arguments(const glslang::TIntermSequence& sequence, bool wide = false);
  std::string arguments(const std::vector<const glslang::TIntermTyped*>& operands, bool wide = false);
  // An expression with its prelude, if there is any, folded into a lambda.
  Text enclosed(const glslang::TIntermTyped& node, bool wants_value);
  // What reads and what writes an l-value: `v.xz()` and `swizzle<0, 2>(v)`, or twice the same. `bind`: find
  // it now, once, through a reference.
  struct Place {
    std::string read;
    std::string write;
  };
  Place place(const glslang::TIntermTyped& left, bool bind);
  bool place_comes_first(const glslang::TIntermTyped& left, const glslang::TIntermTyped& right) const;

  CppContext& context_;
  NameScope& names_;
  std::map<SymbolId, std::string> locals_;
  std::vector<std::string> prelude_;
};

}  // namespace shadertwin::emit
