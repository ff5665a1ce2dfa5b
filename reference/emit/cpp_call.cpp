// Calls, constructors and everything else that has a list of operands.
#include <algorithm>

#include "reference/emit/cpp_expression.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

int component_count(const TType& type) {
  return type.isMatrix() ? type.getMatrixCols() * type.getMatrixRows() : type.getVectorSize();
}

// Whether GLM has this very constructor; make<T>() knows all the others.
bool is_plain_constructor(const TType& type, const TIntermSequence& arguments) {
  const auto all = [&](const auto& condition) {
    return std::all_of(arguments.begin(), arguments.end(),
                       [&](const TIntermNode* node) { return condition(node->getAsTyped()->getType()); });
  };
  if (!all([&](const TType& a) { return a.getBasicType() == type.getBasicType() && !a.isMatrix(); }))
    return false;
  const int count = component_count(type);
  const int given = static_cast<int>(arguments.size());
  if (type.isMatrix()) {
    if (given == 1) return arguments[0]->getAsTyped()->isScalar();
    if (given == count) return all([](const TType& a) { return a.isScalar(); });
    return given == type.getMatrixCols() &&
           all([&](const TType& a) { return a.getVectorSize() == type.getMatrixRows(); });
  }
  if (type.isScalar()) return arguments[0]->getAsTyped()->isScalar();
  if (given == 1)
    return arguments[0]->getAsTyped()->isScalar() ||
           component_count(arguments[0]->getAsTyped()->getType()) == count;
  int total = 0;
  for (const TIntermNode* node : arguments) total += component_count(node->getAsTyped()->getType());
  return total == count;
}

// Whether a C++ reference can bind to an l-value: a variable, or a component, a member or an element of one.
bool is_referable(const TIntermTyped& node) {
  const TIntermBinary* binary = node.getAsBinaryNode();
  if (binary == nullptr) return node.getAsSymbolNode() != nullptr;
  return binary->getOp() != EOpVectorSwizzle && is_referable(*binary->getLeft());
}

}  // namespace

CppExpressions::Text CppExpressions::aggregate(const TIntermAggregate& node, bool wants_value) {
  const TOperator op = node.getOp();
  if (op == EOpFunctionCall) return call(node, wants_value);
  if (op == EOpComma || op == EOpSequence) return comma(node, wants_value);
  if (is_constructor(op)) return constructor(node);
  return builtin_call(node);
}

CppExpressions::Text CppExpressions::comma(const TIntermAggregate& node, bool wants_value) {
  const TIntermSequence& parts = node.getSequence();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const std::string text = statement(*parts[i]->getAsTyped());
    if (!text.empty()) prelude_.push_back(text + ";");
  }
  const TIntermTyped& last = *parts.back()->getAsTyped();
  return wants_value ? expression(last) : Text{statement(last), Binding::comma};
}

CppExpressions::Text CppExpressions::constructor(const TIntermAggregate& node) {
  const TType& type = node.getType();
  const std::string name = type_of(node);
  const std::string values = arguments(node.getSequence());
  if (type.isArray()) return {name + "{{" + values + "}}", Binding::postfix};
  if (type.isStruct()) return {name + "{" + values + "}", Binding::postfix};
  const bool plain = is_plain_constructor(type, node.getSequence());
  return {(plain ? name : "make<" + name + ">") + "(" + values + ")", Binding::postfix};
}

CppExpressions::Text CppExpressions::builtin_call(const TIntermAggregate& node) {
  const std::string name = context_.builtin(builtin_name(node.getOp()));
  const TIntermSequence& sequence = node.getSequence();
  if (node.getOp() == EOpModf && !is_referable(*sequence[1]->getAsTyped())) {
    const TIntermTyped& whole = *sequence[1]->getAsTyped();
    const std::string part = names_.take("whole");
    prelude_.push_back(context_.type(whole.getType()) + " " + part + ";");
    const Text fraction =
        temporary(node, name + "(" + expression(*sequence[0]->getAsTyped()).text + ", " + part + ")");
    prelude_.push_back(place(whole, false).write + " = " + part + ";");
    return fraction;
  }
  // A checking twin asks what the function is given, not how a driver gets around it.
  if (!context_.options().checks) {
    if (const Text special = special_case(node); !special.text.empty()) return special;
  }
  const std::string text = name + "(" + arguments(sequence) + ")";
  const bool samples = name.rfind("tex", 0) == 0 && node.getBasicType() == EbtFloat;
  if (context_.options().checks && samples) return {"sampled__(" + text + ")", Binding::postfix};
  return {text, Binding::postfix};
}

// GLSL copies out and inout arguments in and out. A reference can't be told from that unless the function can
// reach the variable by another way.
bool CppExpressions::can_pass_by_reference(const TIntermAggregate& call, std::size_t argument) {
  const TIntermTyped& node = *call.getSequence()[argument]->getAsTyped();
  if (!is_referable(node)) return false;
  const SymbolId id = base_symbol(node)->getId();
  const Effects& touched = context_.program().function(call).globals;
  if (touched.reads.count(id) != 0 || touched.writes.count(id) != 0) return false;
  for (std::size_t i = 0; i < call.getSequence().size(); ++i) {
    if (i == argument) continue;
    const Effects& other = context_.program().effects(*call.getSequence()[i]);
    if (other.writes.count(id) != 0) return false;
    if (!is_out(call.getQualifierList()[i])) continue;
    const TIntermSymbol* base = base_symbol(*call.getSequence()[i]->getAsTyped());
    if (base != nullptr && base->getId() == id) return false;
  }
  return true;
}

CppExpressions::Text CppExpressions::call(const TIntermAggregate& node, bool wants_value) {
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
  for (std::size_t i = 0; i < in_texts.size(); ++i)
    texts[in_places[i]] = in_texts[i].at_least(Binding::assignment);
  std::vector<std::string> copies_out;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (!is_out(node.getQualifierList()[i])) continue;
    const TIntermTyped& target = *sequence[i]->getAsTyped();
    const Place found = place(target, context_.program().effects(target).writes_any());
    texts[i] = found.read;
    if (can_pass_by_reference(node, i)) continue;
    texts[i] = names_.take("tmp");
    const bool reads = node.getQualifierList()[i] == EvqInOut;
    prelude_.push_back(context_.type(target.getType()) + " " + texts[i] +
                       (reads ? " = " + found.read + ";" : ";"));
    copies_out.push_back(found.write + " = " + texts[i] + ";");
  }

  std::string text = context_.function(callee.name) + "(";
  for (std::size_t i = 0; i < texts.size(); ++i) text += (i > 0 ? ", " : "") + texts[i];
  text += ")";
  if (copies_out.empty()) return {text, Binding::postfix};
  Text result;
  if (node.getBasicType() == EbtVoid || !wants_value)
    prelude_.push_back(text + ";");
  else
    result = temporary(node, text);
  prelude_.insert(prelude_.end(), copies_out.begin(), copies_out.end());
  return result;
}

}  // namespace shadertwin::emit
