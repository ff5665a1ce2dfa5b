#include "reference/emit/cpp_expression.h"

#include <algorithm>
#include <utility>

namespace shadertwin::emit {

using namespace glslang;

namespace {

constexpr const char* component_names = "xyzw";

bool is_integer(const TType& type) {
  return type.getBasicType() == EbtInt || type.getBasicType() == EbtUint;
}

int constant_index(const TIntermTyped& node) {
  const TConstUnion& value = node.getAsConstantUnion()->getConstArray()[0];
  return value.getType() == EbtUint ? static_cast<int>(value.getUConst()) : value.getIConst();
}

std::string glsl_name(const TType& type) {
  const bool is_vector = type.getVectorSize() > 1;
  switch (type.getBasicType()) {
    case EbtFloat:
      return is_vector ? "vec" + std::to_string(type.getVectorSize()) : "float";
    case EbtInt:
      return is_vector ? "ivec" + std::to_string(type.getVectorSize()) : "int";
    case EbtUint:
      return is_vector ? "uvec" + std::to_string(type.getVectorSize()) : "uint";
    default:
      return is_vector ? "bvec" + std::to_string(type.getVectorSize()) : "bool";
  }
}

// Of a variable among a constructor's arguments: `i` in vec2(i, 1.0), but not in vec2(float(i), 1.0).
bool is_implicit_conversion(const SyntaxTree& tree, const TIntermTyped& node) {
  const TIntermUnary* unary = node.getAsUnaryNode();
  if (unary == nullptr || !is_conversion(unary->getOp()) || unary->getOperand()->getAsSymbolNode() == nullptr)
    return false;
  const int token = tree.token_of(*unary->getOperand());
  return token >= 2 && (tree.tokens()[static_cast<std::size_t>(token) - 1].text != "(" ||
                        tree.tokens()[static_cast<std::size_t>(token) - 2].text != glsl_name(node.getType()));
}

// A variable, or a part of it that is known before the shader runs. Browsers and Mesa read it only when the
// operation that it is an operand of is done: `vec2(x, x += 1.0)` has twice the same.
bool is_place(const SyntaxTree& tree, const TIntermTyped& node) {
  if (node.getAsSymbolNode() != nullptr) return true;
  if (is_implicit_conversion(tree, node)) return true;
  const TIntermBinary* part = node.getAsBinaryNode();
  if (part == nullptr) return false;
  const TOperator op = part->getOp();
  return (op == EOpIndexDirect || op == EOpIndexDirectStruct || op == EOpVectorSwizzle) &&
         is_place(tree, *part->getLeft());
}

// A divisor that C++ can divide by as it is: neither 0 nor -1.
bool is_safe_divisor(const TIntermTyped& node) {
  const TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr) return false;
  for (int i = 0; i < constant->getConstArray().size(); ++i) {
    const TConstUnion& value = constant->getConstArray()[i];
    if (value.getType() == EbtUint ? value.getUConst() == 0
                                   : value.getIConst() == 0 || value.getIConst() == -1)
      return false;
  }
  return true;
}

bool is_safe_shift(const TIntermTyped& node) {
  const TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr || !constant->getType().isScalar()) return false;
  const TConstUnion& value = constant->getConstArray()[0];
  return value.getType() == EbtUint ? value.getUConst() < 32
                                    : value.getIConst() >= 0 && value.getIConst() < 32;
}

// The function that stands for an integer operator where C++'s own is undefined; null where it never is.
const char* integer_function(TOperator op, const TIntermTyped& left, const TIntermTyped& right) {
  if (!is_integer(left.getType())) return nullptr;
  const bool both_scalar = left.getType().isScalar() && right.getType().isScalar();
  switch (op) {
    case EOpDiv:
      return is_safe_divisor(right) && both_scalar ? nullptr : "divide";
    case EOpMod:
      return is_safe_divisor(right) && both_scalar ? nullptr : "modulo";
    case EOpLeftShift:
      return is_safe_shift(right) && both_scalar ? nullptr : "shift_left";
    case EOpRightShift:
      return is_safe_shift(right) && both_scalar ? nullptr : "shift_right";
    default:
      return nullptr;
  }
}

}  // namespace

Expression CppExpressions::value(const TIntermTyped& node, bool wide) {
  const Expression text = expression(node);
  return wide ? widened(node, text) : text;
}

std::string CppExpressions::self_contained(const TIntermTyped& node) {
  return enclosed(node, true).text;
}

std::string CppExpressions::self_contained_statement(const TIntermTyped& node) {
  const TIntermAggregate* list = node.getAsAggregate();
  if (list == nullptr || list->getOp() != EOpComma) return enclosed(node, false).text;
  std::string text;
  for (const TIntermNode* part : list->getSequence())
    text += (text.empty() ? "" : ", ") + self_contained_statement(*part->getAsTyped());
  return text;
}

Expression CppExpressions::enclosed(const TIntermTyped& node, bool wants_value) {
  const bool has_value = wants_value && node.getBasicType() != EbtVoid;
  Expression text;
  const std::vector<CppLine> inner =
      out_.capture([&] { text = has_value ? expression(node) : discarded(node); });
  if (inner.empty()) return text;
  std::string lambda = has_value ? "[&]() -> " + type_of(node) + " { " : "[&] { ";
  for (const CppLine& line : inner) lambda += line.written() + ' ';
  if (!text.is_empty()) lambda += (has_value ? "return " : "") + text.text + "; ";
  return {lambda + "}()", Binding::postfix};
}

void CppExpressions::statement(const TIntermTyped& node) {
  if (const Expression text = discarded(node); !text.is_empty()) out_.statement(text.text);
}

Expression CppExpressions::discarded(const TIntermTyped& node) {
  if (const TIntermBinary* binary = node.getAsBinaryNode()) {
    if (assignment_operator(binary->getOp()).sign != nullptr) return assignment(*binary, false);
  }
  if (const TIntermUnary* unary = node.getAsUnaryNode()) {
    if (is_increment(unary->getOp())) return increment(*unary, false);
  }
  if (const TIntermAggregate* call = node.getAsAggregate()) {
    // vec2(a); would declare a in C++.
    if (is_constructor(call->getOp())) return {"(void)" + aggregate(*call, false).text, Binding::prefix};
    return aggregate(*call, false);
  }
  return expression(node);
}

bool CppExpressions::is_read_late(const TIntermTyped& operand) const {
  return is_place(context_.program().tree(), operand);
}

bool CppExpressions::has_effects(const TIntermTyped& node) const {
  return context_.program().effects(node).writes_any();
}

Expression CppExpressions::temporary(const TIntermTyped& node, const std::string& text) {
  const std::string name = names_.take("tmp");
  out_.declare("const " + type_of(node), name, text);
  return {name};
}

bool CppExpressions::order_shows(const std::vector<const TIntermTyped*>& operands,
                                 const std::vector<bool>& is_late, std::size_t i) const {
  const Effects& effects = context_.program().effects(*operands[i]);
  for (std::size_t j = 0; j < operands.size(); ++j) {
    // What writes a place that is read late has to come first.
    const bool reads_before = j > i && !is_late[i];
    const bool writes_before = j < i && is_late[j];
    if ((reads_before || writes_before) && effects.conflicts_with(context_.program().effects(*operands[j])))
      return true;
  }
  return false;
}

std::vector<Expression> CppExpressions::in_order(const std::vector<const TIntermTyped*>& operands,
                                                 bool wide) {
  std::vector<bool> is_late;
  for (const TIntermTyped* operand : operands) is_late.push_back(is_read_late(*operand));
  std::vector<Expression> texts;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    Expression text = expression(*operands[i]);
    if (order_shows(operands, is_late, i)) text = temporary(*operands[i], text.text);
    texts.push_back(wide ? widened(*operands[i], text) : text);
  }
  return texts;
}

std::string CppExpressions::arguments(const TIntermSequence& sequence, bool wide) {
  std::vector<const TIntermTyped*> operands;
  for (const TIntermNode* node : sequence) operands.push_back(node->getAsTyped());
  return arguments(operands, wide);
}

std::string CppExpressions::arguments(const std::vector<const TIntermTyped*>& operands, bool wide) {
  const std::vector<Expression> texts = in_order(operands);
  std::string text;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Expression argument = wide ? packed(*operands[i], texts[i]) : texts[i];
    text += (text.empty() ? "" : ", ") + argument.at_least(Binding::assignment);
  }
  return text;
}

std::string CppExpressions::type_of(const TIntermTyped& node) const {
  return context_.type(node.getType());
}

Expression CppExpressions::expression(const TIntermTyped& node) {
  if (const TIntermSymbol* name = node.getAsSymbolNode()) return symbol(*name);
  if (const TIntermConstantUnion* constant = node.getAsConstantUnion()) return context_.constant(*constant);
  if (const TIntermBinary* operation = node.getAsBinaryNode()) return binary(*operation);
  if (const TIntermUnary* operation = node.getAsUnaryNode()) return unary(*operation);
  if (const TIntermSelection* choice = node.getAsSelectionNode()) return selection(*choice);
  return aggregate(*node.getAsAggregate(), true);
}

Expression CppExpressions::symbol(const TIntermSymbol& node) {
  const auto found = scope_.locals.find(node.getId());
  return {found != scope_.locals.end() ? found->second : context_.global(node)};
}

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

Expression CppExpressions::binary(const TIntermBinary& node) {
  const TOperator op = node.getOp();
  if (!swizzle_of(node).components.empty()) return component(swizzle_of(node));
  if (op == EOpIndexDirect || op == EOpIndexIndirect || op == EOpIndexDirectStruct) return index(node);
  if (assignment_operator(op).sign != nullptr) return assignment(node, true);
  return arithmetic(node);
}

Expression CppExpressions::arithmetic(const TIntermBinary& node) {
  const TOperator op = node.getOp();
  if (op == EOpLogicalAnd || op == EOpLogicalOr) return logical(node);
  const std::vector<Expression> operands = in_order({node.getLeft(), node.getRight()}, varies(node));
  return arithmetic(op, *node.getLeft(), *node.getRight(), operands[0], operands[1]);
}

Expression CppExpressions::logical(const TIntermBinary& node) {
  const BinaryOperator sign = binary_operator(node.getOp());
  const Expression left = expression(*node.getLeft());
  const Expression right = enclosed(*node.getRight(), true);  // it may not run at all
  return {left.at_least(sign.binding) + ' ' + sign.sign + ' ' + right.at_least(above(sign.binding)),
          sign.binding};
}

Expression CppExpressions::arithmetic(TOperator op, const TIntermTyped& left, const TIntermTyped& right,
                                      const Expression& left_text, const Expression& right_text) {
  if (const char* function = integer_function(op, left, right)) {
    const bool wide = varies(left) || varies(right);
    return call_of(function, (wide ? packed(left, left_text) : left_text).text + ", " +
                                 (wide ? packed(right, right_text) : right_text).text);
  }
  const bool compares = op == EOpEqual || op == EOpNotEqual;
  const std::string both = left_text.text + ", " + right_text.text;
  if (compares && !left.isScalar() && (varies(left) || varies(right)))
    return op == EOpEqual ? call_of("same__", both)
                          : Expression{"!same__(" + both + ")", Binding::prefix, '!'};
  if (needs_division_check(op, left, right)) return call_of("checked_divide", both);
  BinaryOperator sign = binary_operator(op);
  if (op == EOpLogicalXor) sign = binary_operator(EOpNotEqual);
  return {left_text.at_least(sign.binding) + ' ' + sign.sign + ' ' + right_text.at_least(above(sign.binding)),
          sign.binding};
}

bool CppExpressions::needs_division_check(TOperator op, const TIntermTyped& left,
                                          const TIntermTyped& right) const {
  if (!context_.options().checks || op != EOpDiv || left.getBasicType() != EbtFloat) return false;
  const TIntermConstantUnion* constant = right.getAsConstantUnion();
  if (constant == nullptr) return true;
  for (int i = 0; i < constant->getConstArray().size(); ++i) {
    if (constant->getConstArray()[i].getDConst() == 0) return true;
  }
  return false;
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

Expression CppExpressions::conversion(const TIntermTyped& node, const TIntermTyped& operand) {
  const bool plain = node.isScalar() && operand.isScalar() && node.getBasicType() != EbtBool &&
                     operand.getBasicType() != EbtFloat && !varies(node);
  const std::string type = type_of(node);
  return call_of(plain ? type : "make<" + type + ">", expression(operand).text);
}

Expression CppExpressions::unary(const TIntermUnary& node) {
  const TOperator op = node.getOp();
  const TIntermTyped& operand = *node.getOperand();
  if (is_increment(op)) return increment(node, true);
  if (is_conversion(op)) return conversion(node, operand);
  const auto prefix = [&](char sign) {
    const Expression value = expression(operand);
    const Binding needed = value.sign == sign ? Binding::postfix : Binding::prefix;
    return Expression{sign + value.at_least(needed), Binding::prefix, sign};
  };
  switch (op) {
    case EOpNegative:
      return prefix('-');
    case EOpLogicalNot:
      return prefix('!');
    case EOpBitwiseNot:
      return prefix('~');
    default:
      break;
  }
  if (const char* name = builtin_name(op)) return call_of(context_.builtin(name), expression(operand).text);
  return conversion(node, operand);
}

Expression CppExpressions::selection(const TIntermSelection& node) {
  const Expression condition = expression(*node.getCondition());
  const Expression yes = enclosed(*node.getTrueBlock()->getAsTyped(), true);
  const Expression no = enclosed(*node.getFalseBlock()->getAsTyped(), true);
  return {condition.at_least(above(Binding::conditional)) + " ? " + yes.at_least(Binding::conditional) +
              " : " + no.at_least(Binding::conditional),
          Binding::conditional};
}

}  // namespace shadertwin::emit
