// GLSL expressions as C++.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/cpp_context.h"
#include "reference/emit/expression.h"
#include "reference/emit/function_scope.h"

namespace shadertwin::emit {

// What C++ can't say in one expression in GLSL's order is said by statements in front of it, which go
// straight into the function's text.
class CppExpressions {
 public:
  CppExpressions(CppContext& context, FunctionScope& scope)
      : context_(context), scope_(scope), names_(scope.names), out_(scope.out) {}
  virtual ~CppExpressions() = default;
  CppExpressions(const CppExpressions&) = delete;
  CppExpressions& operator=(const CppExpressions&) = delete;

  // `wide`: for a variable that varies.
  Expression value(const glslang::TIntermTyped& node, bool wide = false);
  // The same for a place where no statement can stand in front, such as a loop's condition.
  std::string self_contained(const glslang::TIntermTyped& node);
  // An expression whose value nobody wants.
  void statement(const glslang::TIntermTyped& node);
  // The same for what stands behind a loop's second semicolon.
  std::string self_contained_statement(const glslang::TIntermTyped& node);

 protected:
  // A multi-component swizzle, composed: v.zyx.xy is {v, 2, 1}.
  struct Swizzle {
    const glslang::TIntermTyped* base = nullptr;
    std::vector<int> components;
  };

  // An element that each pixel chooses for itself: read into a variable, changed there, and put back. Packets
  // only.
  struct Element {
    std::string type;
    std::string container;
    std::string index;
    std::string name;
  };
  // An l-value whose indices have been found. What reads it and what writes it are the same text but for
  // several components: `v.xz()` and `swizzle<0, 2>(v)`.
  struct Place {
    std::string read;
    std::string write;
    bool is_swizzle = false;
    std::vector<Element> elements;  // each inside the one before

    Expression value() const { return {read, Binding::postfix}; }
  };

  // What packets (packet_expression.h) say in another way.
  virtual std::string type_of(const glslang::TIntermTyped& node) const;
  // Whether the value may differ between the pixels of a packet.
  virtual bool varies(const glslang::TIntermTyped& /*node*/) const { return false; }
  // `text` of an operand, as it has to be where the others vary.
  virtual Expression widened(const glslang::TIntermTyped& /*node*/, Expression text) const { return text; }
  // The same for an argument of a function with overloads: there C++ has to see the very type.
  virtual Expression packed(const glslang::TIntermTyped& /*node*/, Expression text) const { return text; }
  virtual Expression logical(const glslang::TIntermBinary& node);
  virtual Expression assignment(const glslang::TIntermBinary& node, bool wants_value);
  virtual Expression increment(const glslang::TIntermUnary& node, bool wants_value);
  virtual Expression selection(const glslang::TIntermSelection& node);
  virtual Expression constructor(const glslang::TIntermAggregate& node);
  virtual Expression builtin_call(const glslang::TIntermAggregate& node);
  // The elements of a place as they are now, and a place's new value.
  virtual void load(const Place& /*place*/) {}
  virtual void copy_out(const Place& place, const std::string& value);
  // Of a call: what stands in front of its arguments, an argument as `parameter` takes it, and what follows
  // where pixels may end in it.
  virtual std::string mask_argument() const { return {}; }
  virtual Expression in_argument(const Parameter& /*parameter*/, const glslang::TIntermTyped& /*node*/,
                                 Expression text) const {
    return text;
  }
  virtual bool may_discard(const Function& /*callee*/) const { return false; }
  virtual void leave_discarded() {}

  Expression expression(const glslang::TIntermTyped& node);
  Expression symbol(const glslang::TIntermSymbol& node);
  Expression binary(const glslang::TIntermBinary& node);
  Expression arithmetic(const glslang::TIntermBinary& node);
  Expression arithmetic(glslang::TOperator op, const glslang::TIntermTyped& left,
                        const glslang::TIntermTyped& right, const Expression& left_text,
                        const Expression& right_text);
  // Whether `left / right` is a division of floats that a checking twin looks at.
  bool needs_division_check(glslang::TOperator op, const glslang::TIntermTyped& left,
                            const glslang::TIntermTyped& right) const;
  // The place of a call in a twin with shadows; 0 in others, and if it has none.
  int place_of(const glslang::TIntermTyped& call) const;
  // For a twin with shadows: `left op right` at its place; empty if it says nothing there.
  Expression operation(glslang::TOperator op, const glslang::TIntermTyped& left,
                       const glslang::TIntermTyped& right, const std::string& operands);
  // A call of a function that may lose digits: `sin_at__(12, x)` in a twin with shadows.
  Expression function_call(const std::string& name, const glslang::TIntermTyped& node,
                           const std::string& arguments);
  // make<ivec2>(x) of floats.
  Expression made(const std::string& type, const glslang::TIntermTyped& node, const std::string& values);
  Expression derivative(const std::string& name, const glslang::TIntermTyped& node, const std::string& value);
  Expression index(const glslang::TIntermBinary& node);
  Expression component(const Swizzle& swizzle);
  Expression unary(const glslang::TIntermUnary& node);
  Expression conversion(const glslang::TIntermTyped& node, const glslang::TIntermTyped& operand);
  Expression aggregate(const glslang::TIntermAggregate& node, bool wants_value);
  Expression call(const glslang::TIntermAggregate& node, bool wants_value);
  // A built-in that Mesa computes in another way because of its constant arguments; empty if it doesn't.
  Expression special_case(const glslang::TIntermAggregate& node);
  Expression comma(const glslang::TIntermAggregate& node, bool wants_value);
  // An expression whose value nobody wants, as far as the statements in front of it don't say it all.
  Expression discarded(const glslang::TIntermTyped& node);

  static Swizzle swizzle_of(const glslang::TIntermTyped& node);
  bool has_effects(const glslang::TIntermTyped& node) const;
  // Whether an operand is read only when all operands have been evaluated.
  bool is_read_late(const glslang::TIntermTyped& operand) const;
  bool can_pass_by_reference(const glslang::TIntermAggregate& call, std::size_t argument);
  // Whether C++ could evaluate operand `i` at another time than GLSL, and it shows. `is_late`: which operands
  // are read only when all others have been evaluated.
  bool order_shows(const std::vector<const glslang::TIntermTyped*>& operands,
                   const std::vector<bool>& is_late, std::size_t i) const;
  // Evaluates operands from left to right, each into a temporary where C++ could choose another order.
  // `wide`: among operands that vary.
  std::vector<Expression> in_order(const std::vector<const glslang::TIntermTyped*>& operands,
                                   bool wide = false);
  Expression temporary(const glslang::TIntermTyped& node, const std::string& text);
  std::string arguments(const glslang::TIntermSequence& sequence, bool wide = false);
  std::string arguments(const std::vector<const glslang::TIntermTyped*>& operands, bool wide = false);
  // An expression, folded into a lambda if statements have to stand in front of it.
  Expression enclosed(const glslang::TIntermTyped& node, bool wants_value);
  // Finds an l-value: its indices once and in GLSL's order, those with effects, and all if `bind`, since what
  // follows may change them.
  Place place(const glslang::TIntermTyped& left, bool bind);
  bool place_comes_first(const glslang::TIntermTyped& left, const glslang::TIntermTyped& right) const;
  std::string one(const glslang::TType& type) const;

  CppContext& context_;
  FunctionScope& scope_;
  NameScope& names_;
  CppWriter& out_;

 private:
  std::string component_table(const std::vector<int>& components, const glslang::TIntermTyped& index) const;
  std::string chain(const glslang::TIntermTyped& node, bool bind, std::vector<Element>& elements);
};

}  // namespace shadertwin::emit
