// GLSL expressions as C++ over packets: eight pixels at once, under the mask of those that run.
#pragma once

#include <string>

#include "reference/emit/cpp_expression.h"
#include "reference/emit/masks.h"
#include "reference/emit/uniformity.h"

namespace shadertwin::emit {

class PacketExpressions : public CppExpressions {
 public:
  PacketExpressions(CppContext& context, FunctionScope& scope, Masks& masks, const Uniformity& uniformity)
      : CppExpressions(context, scope), masks_(masks), uniformity_(uniformity) {}

 private:
  std::string type_of(const glslang::TIntermTyped& node) const override;
  bool varies(const glslang::TIntermTyped& node) const override { return uniformity_.varies(node); }
  Expression widened(const glslang::TIntermTyped& node, Expression text) const override;
  Expression packed(const glslang::TIntermTyped& node, Expression text) const override;
  Expression logical(const glslang::TIntermBinary& node) override;
  Expression assignment(const glslang::TIntermBinary& node, bool wants_value) override;
  Expression increment(const glslang::TIntermUnary& node, bool wants_value) override;
  Expression selection(const glslang::TIntermSelection& node) override;
  Expression constructor(const glslang::TIntermAggregate& node) override;
  Expression builtin_call(const glslang::TIntermAggregate& node) override;
  void load(const Place& place) override;
  void copy_out(const Place& place, const std::string& value) override;
  std::string mask_argument() const override { return masks_.current(); }
  Expression in_argument(const Parameter& parameter, const glslang::TIntermTyped& node,
                         Expression text) const override;
  bool may_discard(const Function& callee) const override { return uniformity_.discards(callee); }
  void leave_discarded() override;

  // `to = value`, for the pixels of the mask alone if the others see it.
  Expression assigned(const std::string& to, const std::string& value, bool masked) const;
  // Gives a place its value, which is loaded, and puts its elements back.
  void store(const Place& place, const std::string& value, bool masked);
  // The same as the last statement of an expression, which is that statement or the value.
  Expression stored(const Place& place, const std::string& value, bool masked, bool wants_value);
  // Runs `body` for the pixels for which `condition` holds; all of them agree if it does not diverge.
  template <class Body>
  void branch(bool diverges, const std::string& condition, const Body& body);
  // A side of a selection, as the value of the whole.
  std::string side_value(const glslang::TIntermTyped& selection, const glslang::TIntermTyped& side);

  Masks& masks_;
  const Uniformity& uniformity_;
};

}  // namespace shadertwin::emit
