// Calls that Mesa rewrites before it computes them, by the shape of their arguments. The twin does the same,
// so that the bits agree. Measured on Mesa 22.3 (tests/glsl); text that is `precise` is left alone, but for
// mix.
#include <optional>

#include "reference/emit/cpp_expression.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

// The one value that all components of a constant have.
std::optional<double> uniform_constant(const TIntermNode& node) {
  const TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr || constant->getBasicType() != EbtFloat) return {};
  const TConstUnionArray& values = constant->getConstArray();
  for (int i = 1; i < values.size(); ++i) {
    if (values[i].getDConst() != values[0].getDConst()) return {};
  }
  return values[0].getDConst();
}

bool is_constant(const TIntermNode& node) {
  return node.getAsConstantUnion() != nullptr;
}

}  // namespace

Expression CppExpressions::special_case(const TIntermAggregate& node) {
  const TIntermSequence& sequence = node.getSequence();
  if (node.getBasicType() != EbtFloat) return {};
  const bool precise = context_.program().tree().is_precise();
  const auto call = [&](const std::string& name, const std::vector<TIntermNode*>& operands) {
    std::vector<const TIntermTyped*> typed;
    for (const TIntermNode* operand : operands) typed.push_back(operand->getAsTyped());
    return function_call(name, node, arguments(typed, varies(node)));
  };
  switch (node.getOp()) {
    case EOpMix: {
      if (sequence[2]->getAsTyped()->getBasicType() == EbtBool) return {};
      const std::optional<double> second = uniform_constant(*sequence[1]);
      const bool to_one = second && (*second == 1.0 || *second == -1.0);
      return precise || to_one || is_constant(*sequence[2])
                 ? call("mix_strict", {sequence[0], sequence[1], sequence[2]})
                 : Expression{};
    }
    case EOpMin:
    case EOpMax:  // the order shows in the sign of a zero
      if (!is_constant(*sequence[0]) || is_constant(*sequence[1])) return {};
      if (sequence[0]->getAsTyped()->getVectorSize() != sequence[1]->getAsTyped()->getVectorSize()) return {};
      return call(node.getOp() == EOpMin ? "min" : "max", {sequence[1], sequence[0]});
    case EOpPow: {
      if (precise) return {};
      if (uniform_constant(*sequence[0]) == 2.0) return call("exp2", std::vector<TIntermNode*>{sequence[1]});
      const std::optional<double> exponent = uniform_constant(*sequence[1]);
      if (exponent != 1.0 && exponent != 2.0 && exponent != 4.0) return {};
      const TIntermTyped& base = *sequence[0]->getAsTyped();
      Expression x = expression(base);
      if (exponent == 1.0) return x;
      if (base.getAsSymbolNode() == nullptr) x = temporary(base, x.text);
      const int place = place_of(node);
      const auto product = [&](const std::string& factor) {
        return place == 0 ? factor + " * " + factor
                          : "multiply__(" + std::to_string(place) + ", " + factor + ", " + factor + ")";
      };
      const std::string square = product(x.text);
      if (exponent == 2.0) return {square, Binding::product};
      return {product("(" + square + ")"), Binding::product};
    }
    default:
      return {};
  }
}

}  // namespace shadertwin::emit
