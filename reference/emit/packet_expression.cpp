#include "reference/emit/packet_expression.h"

#include <utility>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

constexpr const char* component_names = "xyzw";
constexpr const char* uniform_space = "uniform::";

bool is_index(TOperator op) {
  return op == EOpIndexDirect || op == EOpIndexIndirect;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

}  // namespace

std::string PacketExpressions::type_of(const TIntermTyped& node) const {
  return context_.type(node.getType(), varies(node));
}

// A scalar becomes a packet by itself; C++ would have to guess for anything larger.
CppExpressions::Text PacketExpressions::widened(const TIntermTyped& node, Text text) const {
  if (varies(node) || node.isScalar() || node.getBasicType() == EbtSampler) return text;
  if (node.isArray()) return {"spread__(" + text.text + ")", Binding::postfix};
  const std::string type = context_.type(node.getType(), true);
  if (node.isMatrix()) return {"make<" + type + ">(" + text.text + ")", Binding::postfix};
  const std::string constructor = uniform_space + type + "(";
  if (node.getAsConstantUnion() != nullptr && starts_with(text.text, constructor))
    return {text.text.substr(std::string(uniform_space).size()), text.binding};
  return {type + "(" + text.text + ")", Binding::postfix};
}

CppExpressions::Text PacketExpressions::packed(const TIntermTyped& node, Text text) const {
  if (varies(node) || !node.isScalar() || node.getBasicType() == EbtSampler) return widened(node, text);
  return {context_.type(node.getType(), true) + "(" + text.text + ")", Binding::postfix};
}

bool PacketExpressions::has_effects(const TIntermTyped& node) const {
  return context_.program().effects(node).writes_any();
}

template <class Body>
void PacketExpressions::where(const std::string& condition, const Body& body) {
  const std::string inner = names_.take("active");
  say("if (Bool " + inner + " = " + condition + "; some__(" + inner + ")) {");
  std::vector<std::string> outer = std::exchange(prelude_, {});
  masks_.push_back(inner);
  body();
  masks_.pop_back();
  for (const std::string& line : prelude_) outer.push_back("  " + line);
  prelude_ = std::move(outer);
  say("}");
}

CppExpressions::Text PacketExpressions::logical(const TIntermBinary& node) {
  const TIntermTyped& left = *node.getLeft();
  const TIntermTyped& right = *node.getRight();
  if (!varies(node) && !has_effects(right)) return CppExpressions::logical(node);
  const BinaryOperator sign = binary_operator(node.getOp());
  Text left_text = expression(left);
  if (!has_effects(right) && !is_costly(right)) {
    if (has_effects(left)) left_text = temporary(left, left_text.text);
    const Text right_text = expression(right);
    const Binding above = static_cast<Binding>(static_cast<int>(sign.binding) + 1);
    return {left_text.at_least(sign.binding) + ' ' + sign.sign + ' ' + right_text.at_least(above),
            sign.binding};
  }
  const bool is_and = node.getOp() == EOpLogicalAnd;
  const std::string first = temporary(left, left_text.text).text;
  const std::string result = names_.take("tmp");
  say(type_of(node) + " " + result + " = " + first + ";");
  if (!varies(left)) {
    say(std::string("if (") + (is_and ? "" : "!") + first + ") {");
    std::vector<std::string> outer = std::exchange(prelude_, {});
    const Text right_text = expression(right);
    say(result + " = " + right_text.text + ";");
    for (const std::string& line : prelude_) outer.push_back("  " + line);
    prelude_ = std::move(outer);
    say("}");
    return {result};
  }
  where(mask() + " && " + (is_and ? "" : "!") + first, [&] {
    const Text right_text = expression(right);
    say("set__(" + mask() + ", " + result + ", " + right_text.text + ");");
  });
  return {result};
}

std::string PacketExpressions::branch_value(const TIntermTyped& selection, const TIntermTyped& branch) {
  const Text text = expression(branch);
  if (!varies(selection) || varies(branch)) return text.at_least(Binding::assignment);
  if (branch.isScalar()) return context_.type(branch.getType(), true) + "(" + text.text + ")";
  return widened(branch, text).at_least(Binding::assignment);
}

CppExpressions::Text PacketExpressions::selection(const TIntermSelection& node) {
  const TIntermTyped& yes = *node.getTrueBlock()->getAsTyped();
  const TIntermTyped& no = *node.getFalseBlock()->getAsTyped();
  Text condition = expression(*node.getCondition());
  if (has_effects(*node.getCondition())) condition = temporary(*node.getCondition(), condition.text);
  const bool parts = varies(*node.getCondition());
  const bool has_value = node.getBasicType() != EbtVoid;
  // The texts, with what has to stand before them.
  const auto side = [&](const TIntermTyped& branch) {
    std::vector<std::string> outer = std::exchange(prelude_, {});
    std::string text = branch_value(node, branch);
    return std::pair(std::move(text), std::exchange(prelude_, std::move(outer)));
  };
  const bool is_plain = has_value && !node.isArray() && !node.getType().isStruct();
  if (!parts && is_plain && !has_effects(yes) && !has_effects(no)) {
    const auto [yes_text, yes_prelude] = side(yes);
    const auto [no_text, no_prelude] = side(no);
    if (yes_prelude.empty() && no_prelude.empty())
      return {"(" + condition.text + ") ? " + yes_text + " : " + no_text, Binding::conditional};
  }
  if (parts && is_plain && !has_effects(yes) && !has_effects(no) && !is_costly(yes) && !is_costly(no)) {
    const std::string yes_text = branch_value(node, yes);
    const std::string no_text = branch_value(node, no);
    return {"select__(" + condition.at_least(Binding::assignment) + ", " + yes_text + ", " + no_text + ")",
            Binding::postfix};
  }

  const std::string result = has_value ? names_.take("tmp") : "";
  const std::string test = names_.take("condition");
  say(std::string("const ") + (parts ? "Bool " : "bool ") + test + " = " + condition.text + ";");
  if (has_value) say(type_of(node) + " " + result + "{};");
  const auto branch = [&](const TIntermTyped& value) {
    if (!has_value) {
      const std::string text = statement(value);
      if (!text.empty()) say(text + ";");
      return;
    }
    const std::string text = branch_value(node, value);
    say(parts ? "set__(" + mask() + ", " + result + ", " + text + ");" : result + " = " + text + ";");
  };
  for (const bool is_yes : {true, false}) {
    const std::string holds = (is_yes ? "" : "!") + test;
    const TIntermTyped& value = is_yes ? yes : no;
    if (parts) {
      where(mask() + " && " + holds, [&] { branch(value); });
    } else {
      say("if (" + holds + ") {");
      std::vector<std::string> outer = std::exchange(prelude_, {});
      branch(value);
      for (const std::string& line : prelude_) outer.push_back("  " + line);
      prelude_ = std::move(outer);
      say("}");
    }
  }
  return {result};
}

// --- Assignments ------------------------------------------------------------

// Indices are found once and in GLSL's order: those with effects, and all if what follows may change them.
std::string PacketExpressions::chain(const TIntermTyped& node, bool bind, std::vector<Element>& elements) {
  const TIntermBinary* binary = node.getAsBinaryNode();
  if (binary == nullptr) return expression(node).at_least(Binding::postfix);
  const TIntermTyped& container = *binary->getLeft();
  if (binary->getOp() == EOpIndexDirectStruct) {
    const int member = binary->getRight()->getAsConstantUnion()->getConstArray()[0].getIConst();
    return chain(container, bind, elements) + '.' + context_.field(container.getType(), member);
  }
  if (!is_index(binary->getOp())) return expression(node).at_least(Binding::postfix);
  const Swizzle one = swizzle_of(node);
  if (one.components.size() == 1)
    return chain(*one.base, bind, elements) + '.' + component_names[one.components[0]];
  const std::string base = chain(container, bind, elements);
  const TIntermTyped& right = *binary->getRight();
  Text index = expression(right);
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

PacketExpressions::Target PacketExpressions::target(const TIntermTyped& left, bool bind) {
  Target result;
  const Swizzle swizzle = swizzle_of(left);
  const bool is_swizzle = swizzle.components.size() > 1;
  const std::string text = chain(is_swizzle ? *swizzle.base : left, bind, result.elements);
  result.place = {text, text};
  if (!is_swizzle) return result;
  std::string letters;
  std::string numbers;
  for (const int component : swizzle.components) {
    letters += component_names[component];
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(component);
  }
  result.place = {text + '.' + letters + "()", "swizzle<" + numbers + ">(" + text + ")"};
  return result;
}

void PacketExpressions::read_elements(const Target& target) {
  for (const Element& element : target.elements)
    say(element.type + " " + element.name + " = at(" + element.container + ", " + element.index + ");");
}

void PacketExpressions::read_elements_again(const Target& target) {
  for (const Element& element : target.elements)
    say(element.name + " = at(" + element.container + ", " + element.index + ");");
}

void PacketExpressions::write(const Target& target, const std::string& value, bool masked) {
  if (masked)
    say("set__(" + mask() + ", " + target.place.write + ", " + value + ");");
  else
    say(target.place.write + " = " + value + ";");
  for (auto element = target.elements.rbegin(); element != target.elements.rend(); ++element)
    say("put__(" + mask() + ", " + element->container + ", " + element->index + ", " + element->name + ");");
}

CppExpressions::Text PacketExpressions::assignment(const TIntermBinary& node, bool wants_value) {
  const TIntermTyped& left = *node.getLeft();
  const TIntermTyped& right = *node.getRight();
  const bool masked = uniformity_.is_masked(node);
  const BinaryOperator op = assignment_operator(node.getOp());
  if (!varies(left)) return CppExpressions::assignment(node, wants_value);
  // GLSL finds the place first, and reads it when the value is there.
  const Target to = target(left, place_comes_first(left, right));
  Text value = expression(right);
  const bool reads_place = op.plain != EOpNull || !to.elements.empty();
  if (reads_place && has_effects(right)) value = temporary(right, value.text);
  value = widened(right, value);
  read_elements(to);
  if (op.plain != EOpNull)
    value = arithmetic(op.plain, left, right, {to.place.read, Binding::postfix}, value);
  const std::string text = value.at_least(Binding::assignment);
  if (to.elements.empty() && !wants_value)
    return masked ? Text{"set__(" + mask() + ", " + to.place.write + ", " + text + ")", Binding::postfix}
                  : Text{to.place.write + " = " + text, Binding::assignment};
  write(to, text, masked);
  return wants_value ? Text{to.place.read, Binding::postfix} : Text{};
}

CppExpressions::Text PacketExpressions::increment(const TIntermUnary& node, bool wants_value) {
  const TIntermTyped& operand = *node.getOperand();
  if (!varies(operand)) return CppExpressions::increment(node, wants_value);
  const bool masked = uniformity_.is_masked(node);
  const TOperator op = node.getOp();
  const bool adds = op == EOpPreIncrement || op == EOpPostIncrement;
  const bool before = op == EOpPreIncrement || op == EOpPreDecrement;
  const Target to = target(operand);
  read_elements(to);
  Text result = {to.place.read, Binding::postfix};
  if (wants_value && !before) result = temporary(operand, to.place.read);
  const std::string one = operand.getBasicType() == EbtFloat  ? context_.literal(1.0)
                          : operand.getBasicType() == EbtUint ? "1u"
                                                              : "1";
  const std::string value = to.place.read + (adds ? " + " : " - ") + one;
  if (to.elements.empty() && !wants_value) {
    if (masked) return {"set__(" + mask() + ", " + to.place.write + ", " + value + ")", Binding::postfix};
    return {to.place.write + " = " + value, Binding::assignment};
  }
  write(to, value, masked);
  return result;
}

// --- Calls ------------------------------------------------------------------

CppExpressions::Text PacketExpressions::constructor(const TIntermAggregate& node) {
  const TType& type = node.getType();
  if (!varies(node)) return CppExpressions::constructor(node);
  if (!type.isMatrix() && !type.isArray() && !type.isStruct()) return CppExpressions::constructor(node);
  const std::string name = context_.type(type, true);
  const std::string values = arguments(node.getSequence(), type.isArray() || type.isStruct());
  if (type.isArray()) return {name + "{{" + values + "}}", Binding::postfix};
  if (type.isStruct()) return {name + "{" + values + "}", Binding::postfix};
  return {"make<" + name + ">(" + values + ")", Binding::postfix};
}

CppExpressions::Text PacketExpressions::builtin_call(const TIntermAggregate& node) {
  const std::string name = context_.builtin(builtin_name(node.getOp()));
  const TIntermSequence& sequence = node.getSequence();
  if (node.getOp() == EOpModf) {
    const TIntermTyped& whole = *sequence[1]->getAsTyped();
    const Text value = expression(*sequence[0]->getAsTyped());
    const std::string type = type_of(node);
    const std::string part = names_.take("whole");
    say(type + " " + part + ";");
    const std::string given = type + "(" + value.text + ")";
    const Text fraction = temporary(node, name + "(" + given + ", " + part + ")");
    const Target to = target(whole);
    read_elements(to);
    write(to, part, uniformity_.is_masked(node));
    return fraction;
  }
  const bool reads_texture = starts_with(name, "tex");
  if (reads_texture) {
    const std::string values = arguments(sequence, false);
    if (!varies(node)) return {"glsl::" + name + "(" + values + ")", Binding::postfix};
    return {name + "(" + mask() + ", " + values + ")", Binding::postfix};
  }
  if (const Text special = special_case(node); !special.text.empty()) return special;
  return {name + "(" + arguments(sequence, varies(node)) + ")", Binding::postfix};
}

CppExpressions::Text PacketExpressions::call(const TIntermAggregate& node, bool wants_value) {
  const Function& callee = context_.program().function(node);
  const TIntermSequence& sequence = node.getSequence();
  std::vector<const TIntermTyped*> in_operands;
  std::vector<std::size_t> in_places;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (is_out(node.getQualifierList()[i])) continue;
    in_operands.push_back(sequence[i]->getAsTyped());
    in_places.push_back(i);
  }
  const std::vector<Text> in_texts = in_order(in_operands);
  std::vector<std::string> texts(sequence.size());
  for (std::size_t i = 0; i < in_texts.size(); ++i) {
    const bool wide = uniformity_.varies(*callee.parameters[in_places[i]].symbol);
    const Text text = wide ? packed(*in_operands[i], in_texts[i]) : in_texts[i];
    texts[in_places[i]] = text.at_least(Binding::assignment);
  }

  // The callee writes the lanes of its mask only, so that a reference will do where it can't be told.
  struct CopyOut {
    Target target;
    std::string value;
  };
  std::vector<CopyOut> copies_out;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (!is_out(node.getQualifierList()[i])) continue;
    const TIntermTyped& operand = *sequence[i]->getAsTyped();
    const Target found = target(operand);
    read_elements(found);
    texts[i] = found.place.read;
    if (found.elements.empty() && can_pass_by_reference(node, i)) continue;
    texts[i] = names_.take("tmp");
    say(context_.type(operand.getType(), true) + " " + texts[i] + " = " + found.place.read + ";");
    copies_out.push_back({found, texts[i]});
  }

  std::string text = context_.function(callee.name) + "(" + mask();
  for (const std::string& argument : texts) text += ", " + argument;
  text += ")";
  const bool discards = uniformity_.discards(callee);
  if (copies_out.empty() && !discards) return {text, Binding::postfix};
  Text result;
  if (node.getBasicType() == EbtVoid || !wants_value)
    say(text + ";");
  else
    result = temporary(node, text);
  for (const CopyOut& copy : copies_out) {
    // Another argument may be a part of the same element.
    read_elements_again(copy.target);
    write(copy.target, copy.value, true);
  }
  if (discards) {
    std::string names;
    for (auto name = masks_.rbegin(); name != masks_.rend(); ++name) names += ", " + *name;
    say("keep__(alive__" + names + ");");
  }
  return result;
}

}  // namespace shadertwin::emit
