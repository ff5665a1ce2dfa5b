#include "reference/emit/cpp_expression.h"

#include <algorithm>
#include <utility>

namespace shadertwin::emit {

using namespace glslang;

namespace {

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
  if (const Expression told = operation(op, left, right, both); !told.is_empty()) return told;
  BinaryOperator sign = binary_operator(op);
  if (op == EOpLogicalXor) sign = binary_operator(EOpNotEqual);
  return {left_text.at_least(sign.binding) + ' ' + sign.sign + ' ' + right_text.at_least(above(sign.binding)),
          sign.binding};
}

int CppExpressions::place_of(const TIntermTyped& call) const {
  return context_.options().shadows ? context_.places().of_call(call) : 0;
}

Expression CppExpressions::operation(TOperator op, const TIntermTyped& left, const TIntermTyped& right,
                                     const std::string& operands) {
  const char* name = operation_name(op);
  const TBasicType type = left.getBasicType();
  if (!context_.options().shadows || name == nullptr || (type != EbtFloat && type != EbtStruct)) return {};
  const int place = context_.places().of_operation(left, right);
  return place == 0 ? Expression{} : call_of(name, std::to_string(place) + ", " + operands);
}

Expression CppExpressions::function_call(const std::string& name, const TIntermTyped& node,
                                         const std::string& arguments) {
  const int place = place_of(node);
  return place == 0 ? call_of(name, arguments)
                    : call_of(name + "_at__", std::to_string(place) + ", " + arguments);
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

Expression CppExpressions::conversion(const TIntermTyped& node, const TIntermTyped& operand) {
  const bool plain = node.isScalar() && operand.isScalar() && node.getBasicType() != EbtBool &&
                     operand.getBasicType() != EbtFloat && !varies(node);
  const std::string type = type_of(node);
  const std::string value = expression(operand).text;
  if (plain) return call_of(type, value);
  return operand.getBasicType() == EbtFloat ? made(type, node, value) : call_of("make<" + type + ">", value);
}

Expression CppExpressions::made(const std::string& type, const TIntermTyped& node,
                                const std::string& values) {
  const int place = place_of(node);
  return place == 0 ? call_of("make<" + type + ">", values)
                    : call_of("make_at__<" + type + ">", std::to_string(place) + ", " + values);
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
  if (const char* name = builtin_name(op)) {
    const std::string value = expression(operand).text;
    if (operand.getBasicType() != EbtFloat) return call_of(context_.builtin(name), value);
    if (is_derivative(op)) return derivative(context_.builtin(name), node, value);
    return function_call(context_.builtin(name), node, value);
  }
  return conversion(node, operand);
}

// A member of the invocation, whose quads meet by the line that it is called on.
Expression CppExpressions::derivative(const std::string& name, const TIntermTyped& node,
                                      const std::string& value) {
  const int place = place_of(node);
  return call_of(name, place == 0 ? value : "at__(" + std::to_string(place) + ", " + value + ")");
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
