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

Expression CppExpressions::aggregate(const TIntermAggregate& node, bool wants_value) {
  const TOperator op = node.getOp();
  if (op == EOpFunctionCall) return call(node, wants_value);
  if (op == EOpComma || op == EOpSequence) return comma(node, wants_value);
  if (is_constructor(op)) return constructor(node);
  return builtin_call(node);
}

Expression CppExpressions::comma(const TIntermAggregate& node, bool wants_value) {
  const TIntermSequence& parts = node.getSequence();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) statement(*parts[i]->getAsTyped());
  const TIntermTyped& last = *parts.back()->getAsTyped();
  return wants_value ? expression(last) : discarded(last);
}

Expression CppExpressions::constructor(const TIntermAggregate& node) {
  const TType& type = node.getType();
  const std::string name = type_of(node);
  const std::string values = arguments(node.getSequence());
  if (type.isArray()) return {name + "{{" + values + "}}", Binding::postfix};
  if (type.isStruct()) return {name + "{" + values + "}", Binding::postfix};
  const bool plain = is_plain_constructor(type, node.getSequence());
  if (plain) return call_of(name, values);
  const bool of_integers = type.getBasicType() != EbtFloat;
  return of_integers ? made(name, node, values) : call_of("make<" + name + ">", values);
}

Expression CppExpressions::builtin_call(const TIntermAggregate& node) {
  const std::string name = context_.builtin(builtin_name(node.getOp()));
  const TIntermSequence& sequence = node.getSequence();
  if (node.getOp() == EOpModf && !is_referable(*sequence[1]->getAsTyped())) {
    const TIntermTyped& whole = *sequence[1]->getAsTyped();
    const std::string part = names_.take("whole");
    out_.statement(context_.type(whole.getType()) + " " + part);
    const std::string given = expression(*sequence[0]->getAsTyped()).text;
    const Expression fraction = temporary(node, function_call(name, node, given + ", " + part).text);
    copy_out(place(whole, false), part);
    return fraction;
  }
  // A checking twin asks what the function is given, not how a driver gets around it.
  if (!context_.options().checks) {
    if (const Expression special = special_case(node); !special.is_empty()) return special;
  }
  const bool computes = !reads_texture(node.getOp()) && !sequence.empty() &&
                        sequence[0]->getAsTyped()->getBasicType() == EbtFloat;
  const std::string given = arguments(sequence);
  if (is_derivative(node.getOp())) return derivative(name, node, given);
  const Expression result = computes ? function_call(name, node, given) : call_of(name, given);
  const bool samples = reads_texture(node.getOp()) && node.getBasicType() == EbtFloat;
  return context_.options().checks && samples ? call_of("sampled__", result.text) : result;
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

// Arguments are evaluated, and the places of out arguments found, from left to right. What comes in through a
// place is read when the call begins, and goes out from left to right when it ends.
Expression CppExpressions::call(const TIntermAggregate& node, bool wants_value) {
  const Function& callee = context_.program().function(node);
  std::vector<const TIntermTyped*> operands;
  std::vector<bool> is_late;
  for (std::size_t i = 0; i < node.getSequence().size(); ++i) {
    operands.push_back(node.getSequence()[i]->getAsTyped());
    is_late.push_back(callee.parameters[i].is_out || is_read_late(*operands[i]));
  }

  std::vector<std::string> texts;
  std::vector<Place> places(operands.size());
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (callee.parameters[i].is_out) {
      const bool bind =
          std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(i) + 1, operands.end(),
                      [&](const TIntermTyped* later) { return place_comes_first(*operands[i], *later); });
      places[i] = place(*operands[i], bind);
      texts.emplace_back();
    } else {
      Expression text = expression(*operands[i]);
      if (order_shows(operands, is_late, i)) text = temporary(*operands[i], text.text);
      texts.push_back(in_argument(callee.parameters[i], *operands[i], text).at_least(Binding::assignment));
    }
  }

  std::vector<std::size_t> copied;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (!callee.parameters[i].is_out) continue;
    load(places[i]);
    texts[i] = places[i].read;
    if (places[i].elements.empty() && can_pass_by_reference(node, i)) continue;
    texts[i] = names_.take("tmp");
    const std::string type = context_.type(operands[i]->getType(), true);
    // Packets keep what the pixels had that don't take part.
    if (callee.parameters[i].is_inout || context_.options().packets)
      out_.declare(type, texts[i], places[i].read);
    else
      out_.statement(type + ' ' + texts[i]);
    copied.push_back(i);
  }

  std::string list = mask_argument();
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + text;
  const Expression called = call_of(context_.function(callee.name), list);
  const bool discards = may_discard(callee);
  if (copied.empty() && !discards) return called;
  Expression result;
  if (node.getBasicType() == EbtVoid || !wants_value)
    out_.statement(called.text);
  else
    result = temporary(node, called.text);
  for (const std::size_t i : copied) copy_out(places[i], texts[i]);
  if (discards) leave_discarded();
  return result;
}

}  // namespace shadertwin::emit
