#include "reference/emit/packet_expression.h"

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

std::string PacketExpressions::type_of(const TIntermTyped& node) const {
  return context_.type(node.getType(), varies(node));
}

// A scalar becomes a packet by itself; C++ would have to guess for anything larger.
Expression PacketExpressions::widened(const TIntermTyped& node, Expression text) const {
  if (varies(node) || node.isScalar() || node.getBasicType() == EbtSampler) return text;
  if (node.isArray()) return call_of("spread__", text.text);
  const std::string type = context_.type(node.getType(), true);
  if (node.isMatrix()) return call_of("make<" + type + ">", text.text);
  if (text.is_literal) return context_.constant(*node.getAsConstantUnion(), true);
  return call_of(type, text.text);
}

Expression PacketExpressions::packed(const TIntermTyped& node, Expression text) const {
  if (varies(node) || !node.isScalar() || node.getBasicType() == EbtSampler) return widened(node, text);
  return call_of(context_.type(node.getType(), true), text.text);
}

Expression PacketExpressions::in_argument(const Parameter& parameter, const TIntermTyped& node,
                                          Expression text) const {
  return uniformity_.varies(*parameter.symbol) ? packed(node, text) : text;
}

template <class Body>
void PacketExpressions::branch(bool diverges, const std::string& condition, const Body& body) {
  if (diverges) return masks_.where({condition}, body);
  out_.begin("if (" + condition + ")");
  body();
  out_.end();
}

Expression PacketExpressions::logical(const TIntermBinary& node) {
  const TIntermTyped& left = *node.getLeft();
  const TIntermTyped& right = *node.getRight();
  if (!varies(node) && !has_effects(right)) return CppExpressions::logical(node);
  const BinaryOperator sign = binary_operator(node.getOp());
  Expression left_text = expression(left);
  if (!has_effects(right) && !is_costly(right)) {
    if (has_effects(left)) left_text = temporary(left, left_text.text);
    const Expression right_text = expression(right);
    return {
        left_text.at_least(sign.binding) + ' ' + sign.sign + ' ' + right_text.at_least(above(sign.binding)),
        sign.binding};
  }
  const std::string first = temporary(left, left_text.text).text;
  const std::string result = names_.take("tmp");
  out_.declare(type_of(node), result, first);
  branch(varies(left), (node.getOp() == EOpLogicalAnd ? "" : "!") + first, [&] {
    const Expression right_text = expression(right);
    out_.statement(assigned(result, right_text.text, varies(left)).text);
  });
  return {result};
}

std::string PacketExpressions::side_value(const TIntermTyped& selection, const TIntermTyped& side) {
  const Expression text = expression(side);
  return (varies(selection) ? packed(side, text) : text).at_least(Binding::assignment);
}

Expression PacketExpressions::selection(const TIntermSelection& node) {
  const TIntermTyped& yes = *node.getTrueBlock()->getAsTyped();
  const TIntermTyped& no = *node.getFalseBlock()->getAsTyped();
  Expression condition = expression(*node.getCondition());
  if (has_effects(*node.getCondition())) condition = temporary(*node.getCondition(), condition.text);
  const bool diverges = varies(*node.getCondition());
  const bool has_value = node.getBasicType() != EbtVoid;
  const bool is_plain = has_value && !node.isArray() && !node.getType().isStruct();
  if (is_plain && !has_effects(yes) && !has_effects(no)) {
    std::string yes_text;
    std::string no_text;
    if (diverges && !is_costly(yes) && !is_costly(no)) {
      yes_text = side_value(node, yes);
      no_text = side_value(node, no);
      return call_of("select__", condition.at_least(Binding::assignment) + ", " + yes_text + ", " + no_text);
    }
    const auto sides = [&] {
      yes_text = side_value(node, yes);
      no_text = side_value(node, no);
    };
    if (!diverges && out_.capture(sides).empty())
      return {"(" + condition.text + ") ? " + yes_text + " : " + no_text, Binding::conditional};
  }

  const std::string result = has_value ? names_.take("tmp") : "";
  const std::string test = names_.take("condition");
  out_.declare(diverges ? "const Bool" : "const bool", test, condition.text);
  if (has_value) out_.statement(type_of(node) + " " + result + "{}");
  const auto side = [&](const TIntermTyped& value) {
    if (has_value)
      out_.statement(assigned(result, side_value(node, value), diverges).text);
    else
      statement(value);
  };
  branch(diverges, test, [&] { side(yes); });
  branch(diverges, "!" + test, [&] { side(no); });
  return {result};
}

// --- Assignments ------------------------------------------------------------

Expression PacketExpressions::assigned(const std::string& to, const std::string& value, bool masked) const {
  if (masked) return call_of("set__", masks_.current() + ", " + to + ", " + value);
  return {to + " = " + value, Binding::assignment};
}

void PacketExpressions::load(const Place& place) {
  for (const Element& element : place.elements)
    out_.declare(element.type, element.name, "at(" + element.container + ", " + element.index + ")");
}

void PacketExpressions::store(const Place& place, const std::string& value, bool masked) {
  out_.statement(assigned(place.write, value, masked).text);
  for (auto element = place.elements.rbegin(); element != place.elements.rend(); ++element)
    out_.statement("put__(" + masks_.current() + ", " + element->container + ", " + element->index + ", " +
                   element->name + ")");
}

Expression PacketExpressions::stored(const Place& place, const std::string& value, bool masked,
                                     bool wants_value) {
  if (place.elements.empty() && !wants_value) return assigned(place.write, value, masked);
  store(place, value, masked);
  return wants_value ? place.value() : Expression{};
}

// Another argument may be a part of the same element.
void PacketExpressions::copy_out(const Place& place, const std::string& value) {
  for (const Element& element : place.elements)
    out_.statement(element.name + " = at(" + element.container + ", " + element.index + ")");
  store(place, value, true);
}

Expression PacketExpressions::assignment(const TIntermBinary& node, bool wants_value) {
  const TIntermTyped& left = *node.getLeft();
  const TIntermTyped& right = *node.getRight();
  const BinaryOperator op = assignment_operator(node.getOp());
  if (!varies(left)) return CppExpressions::assignment(node, wants_value);
  // GLSL finds the place first, and reads it when the value is there.
  const Place to = place(left, place_comes_first(left, right));
  Expression value = expression(right);
  const bool reads_place = op.plain != EOpNull || !to.elements.empty();
  if (reads_place && has_effects(right)) value = temporary(right, value.text);
  value = widened(right, value);
  load(to);
  if (op.plain != EOpNull) value = arithmetic(op.plain, left, right, to.value(), value);
  return stored(to, value.at_least(Binding::assignment), uniformity_.is_masked(node), wants_value);
}

Expression PacketExpressions::increment(const TIntermUnary& node, bool wants_value) {
  const TIntermTyped& operand = *node.getOperand();
  if (!varies(operand)) return CppExpressions::increment(node, wants_value);
  const Step step = step_of(node.getOp());
  const Place to = place(operand, false);
  load(to);
  const bool wants_old = wants_value && !step.is_prefix;
  const Expression old = wants_old ? temporary(operand, to.read) : Expression{};
  const std::string value = to.read + ' ' + step.sign + ' ' + one(operand.getType());
  const Expression result = stored(to, value, uniformity_.is_masked(node), wants_value);
  return wants_old ? old : result;
}

// --- Calls ------------------------------------------------------------------

Expression PacketExpressions::constructor(const TIntermAggregate& node) {
  const TType& type = node.getType();
  if (!varies(node)) return CppExpressions::constructor(node);
  if (!type.isMatrix() && !type.isArray() && !type.isStruct()) return CppExpressions::constructor(node);
  const std::string name = context_.type(type, true);
  const std::string values = arguments(node.getSequence(), type.isArray() || type.isStruct());
  if (type.isArray()) return {name + "{{" + values + "}}", Binding::postfix};
  if (type.isStruct()) return {name + "{" + values + "}", Binding::postfix};
  return call_of("make<" + name + ">", values);
}

Expression PacketExpressions::builtin_call(const TIntermAggregate& node) {
  const std::string name = context_.builtin(builtin_name(node.getOp()));
  const TIntermSequence& sequence = node.getSequence();
  if (node.getOp() == EOpModf) {
    const Expression value = expression(*sequence[0]->getAsTyped());
    const std::string type = type_of(node);
    const std::string part = names_.take("whole");
    out_.statement(type + " " + part);
    const std::string given = call_of(type, value.text).text;
    const Expression fraction = temporary(node, call_of(name, given + ", " + part).text);
    const Place to = place(*sequence[1]->getAsTyped(), false);
    load(to);
    store(to, part, uniformity_.is_masked(node));
    return fraction;
  }
  if (reads_texture(node.getOp())) {
    const std::string values = arguments(sequence, false);
    return varies(node) ? call_of(name, masks_.current() + ", " + values) : call_of("glsl::" + name, values);
  }
  if (const Expression special = special_case(node); !special.is_empty()) return special;
  return call_of(name, arguments(sequence, varies(node)));
}

void PacketExpressions::leave_discarded() {
  out_.statement("keep__(alive__, " + masks_.all() + ")");
}

}  // namespace shadertwin::emit
