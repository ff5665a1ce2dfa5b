// Components and elements, and what is assigned to them.
#include <algorithm>

#include "reference/emit/cpp_expression.h"
#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

constexpr const char* component_names = "xyzw";

int constant_index(const TIntermTyped& node) {
  const TConstUnion& value = node.getAsConstantUnion()->getConstArray()[0];
  return value.getType() == EbtUint ? static_cast<int>(value.getUConst()) : value.getIConst();
}

}  // namespace

CppExpressions::Swizzle CppExpressions::swizzle_of(const TIntermTyped& node) {
  const TIntermBinary* binary = node.getAsBinaryNode();
  std::vector<int> components;
  if (binary != nullptr && binary->getOp() == EOpVectorSwizzle) {
    for (const TIntermNode* selector : binary->getRight()->getAsAggregate()->getSequence())
      components.push_back(constant_index(*selector->getAsTyped()));
  } else if (binary != nullptr && binary->getOp() == EOpIndexDirect && binary->getLeft()->isVector() &&
             !binary->getLeft()->isArray()) {
    components.push_back(
        std::clamp(constant_index(*binary->getRight()), 0, binary->getLeft()->getVectorSize() - 1));
  } else {
    return {&node, {}};
  }
  const Swizzle inner = swizzle_of(*binary->getLeft());
  if (!inner.components.empty()) {
    for (int& component : components) component = inner.components[component];
  }
  return {inner.base, components};
}

Expression CppExpressions::component(const Swizzle& swizzle) {
  std::string text = expression(*swizzle.base).at_least(Binding::postfix) + '.';
  for (const int component : swizzle.components) text += component_names[component];
  if (swizzle.components.size() > 1) text += "()";
  return {text, Binding::postfix};
}

Expression CppExpressions::index(const TIntermBinary& node) {
  const TIntermTyped& left = *node.getLeft();
  if (node.getOp() == EOpIndexDirectStruct) {
    const int member = constant_index(*node.getRight());
    return {expression(left).at_least(Binding::postfix) + '.' + context_.field(left.getType(), member),
            Binding::postfix};
  }
  const std::vector<Expression> parts = in_order({&left, node.getRight()});
  const bool is_array = left.isArray();
  if ((!is_array && node.getOp() == EOpIndexIndirect) || varies(*node.getRight()))
    return call_of("at", parts[0].text + ", " + parts[1].text);
  return {parts[0].at_least(Binding::postfix) + '[' + parts[1].text + ']', Binding::postfix};
}

// Whether evaluating an l-value does, or depends on, what evaluating `right` shows. GLSL finds the place
// first, C++ last.
bool CppExpressions::place_comes_first(const TIntermTyped& left, const TIntermTyped& right) const {
  const Effects& place = context_.program().effects(left);
  if (place.writes_any()) return true;
  const TIntermSymbol* base = base_symbol(left);
  if (base == nullptr || left.getAsSymbolNode() != nullptr) return false;
  const Effects& value = context_.program().effects(right);
  return std::any_of(place.reads.begin(), place.reads.end(),
                     [&](SymbolId id) { return id != base->getId() && value.writes.count(id) != 0; });
}

// `ivec3(2, 1, 0)` for zyx, of the index's own type.
std::string CppExpressions::component_table(const std::vector<int>& components,
                                            const TIntermTyped& index) const {
  const bool is_unsigned = index.getBasicType() == EbtUint;
  std::string numbers;
  for (const int component : components)
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(component) + (is_unsigned ? "u" : "");
  return std::string(context_.options().packets ? "uniform::" : "") + (is_unsigned ? "uvec" : "ivec") +
         std::to_string(components.size()) + "(" + numbers + ")";
}

std::string CppExpressions::chain(const TIntermTyped& node, bool bind, std::vector<Element>& elements) {
  const TIntermBinary* binary = node.getAsBinaryNode();
  if (binary == nullptr) return expression(node).at_least(Binding::postfix);
  const TIntermTyped& container = *binary->getLeft();
  const TIntermTyped& right = *binary->getRight();
  if (binary->getOp() == EOpIndexDirectStruct)
    return chain(container, bind, elements) + '.' +
           context_.field(container.getType(), constant_index(right));
  if (const Swizzle one = swizzle_of(node); one.components.size() == 1)
    return chain(*one.base, bind, elements) + '.' + component_names[one.components[0]];
  // v.zyx[i] is the component of v that stands there.
  const Swizzle parts = swizzle_of(container);
  const bool is_swizzle = parts.components.size() > 1;
  const std::string base = chain(is_swizzle ? *parts.base : container, bind || has_effects(right), elements);
  Expression index = expression(right);
  if (is_swizzle) index = call_of("at", component_table(parts.components, right) + ", " + index.text);
  if (varies(right) || has_effects(right) || (bind && right.getAsConstantUnion() == nullptr))
    index = temporary(right, index.text);
  if (varies(right)) {
    const std::string element = names_.take("element");
    elements.push_back({context_.type(node.getType(), true), base, index.text, element});
    return element;
  }
  if (!container.isArray() && binary->getOp() == EOpIndexIndirect)
    return "at(" + base + ", " + index.text + ")";
  return base + '[' + index.text + ']';
}

CppExpressions::Place CppExpressions::place(const TIntermTyped& left, bool bind) {
  Place result;
  const Swizzle swizzle = swizzle_of(left);
  result.is_swizzle = swizzle.components.size() > 1;
  result.read = result.write = chain(result.is_swizzle ? *swizzle.base : left, bind, result.elements);
  if (!result.is_swizzle) return result;
  std::string letters;
  std::string numbers;
  for (const int component : swizzle.components) {
    letters += component_names[component];
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(component);
  }
  result.write = "swizzle<" + numbers + ">(" + result.read + ")";
  result.read += '.' + letters + "()";
  return result;
}

void CppExpressions::copy_out(const Place& place, const std::string& value) {
  out_.statement(place.write + " = " + value);
}

Expression CppExpressions::assignment(const TIntermBinary& node, bool wants_value) {
  const TIntermTyped& left = *node.getLeft();
  const TIntermTyped& right = *node.getRight();
  const BinaryOperator op = assignment_operator(node.getOp());

  const Place target = place(left, place_comes_first(left, right));
  Expression value = expression(right);
  std::string sign = op.sign;
  // C++ has no such operator on the two types, or not with GLSL's meaning: say it as left = left op right.
  const bool spelled_out =
      op.plain != EOpNull &&
      (integer_function(op.plain, left, right) != nullptr || needs_division_check(op.plain, left, right) ||
       (context_.options().shadows && operation_name(op.plain) != nullptr &&
        left.getBasicType() == EbtFloat) ||
       (right.isMatrix() && op.plain != EOpAdd && op.plain != EOpSub));
  if (spelled_out) {
    if (has_effects(right)) value = temporary(right, value.text);  // the place is read behind it
    value = arithmetic(op.plain, left, right, target.value(), value);
    sign = "=";
  }
  const std::string text = target.write + ' ' + sign + ' ' + value.at_least(Binding::assignment);
  if (!wants_value || !target.is_swizzle) return {text, Binding::assignment};
  out_.statement(text);
  return target.value();
}

std::string CppExpressions::one(const TType& type) const {
  if (type.getBasicType() == EbtFloat) return context_.literal(1.0);
  return type.getBasicType() == EbtUint ? "1u" : "1";
}

Expression CppExpressions::increment(const TIntermUnary& node, bool wants_value) {
  const TIntermTyped& operand = *node.getOperand();
  const Step step = step_of(node.getOp());
  const Place target = place(operand, false);
  const int place_number = operand.getBasicType() == EbtFloat ? place_of(node) : 0;
  if (place_number != 0) out_.statement("at__(" + std::to_string(place_number) + ")");
  if (operand.isScalar()) {
    const std::string sign(2, step.sign);
    return step.is_prefix ? Expression{sign + target.read, Binding::prefix, step.sign}
                          : Expression{target.read + sign, Binding::postfix};
  }
  Expression result = target.value();
  if (wants_value && !step.is_prefix) result = temporary(operand, target.read);
  const std::string text = target.write + ' ' + step.sign + "= " + one(operand.getType());
  if (!wants_value) return {text, Binding::assignment};
  out_.statement(text);
  return result;
}

}  // namespace shadertwin::emit
