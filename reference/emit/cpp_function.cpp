#include "reference/emit/cpp_function.h"

#include <algorithm>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

// What twin::Checks can look at.
bool is_plain_value(const TType& type) {
  return !type.isArray() && !type.isStruct() && type.getBasicType() != EbtVoid;
}

}  // namespace

CppFunction::CppFunction(CppContext& context, const Function& function, FunctionScope& scope,
                         CppExpressions& expressions)
    : context_(context),
      function_(function),
      expressions_(expressions),
      out_(scope.out),
      names_(scope.names),
      scope_(scope),
      placement_(context.program(), function) {
  // A local variable must not hide what this function needs.
  for (const std::string& name : function.calls) names_.reserve(context.function(name));
  for (const std::string& name : function.builtins) names_.reserve(context.builtin(name));
  names_.reserve("exp2");             // pow(2.0, x)
  names_.reserve("uintBitsToFloat");  // infinities
  for (const StructTable::Entry& entry : context.structs().entries()) names_.reserve(entry.name);
  for (const TIntermSymbol* symbol : context.program().globals()) names_.reserve(context.global(*symbol));
  for (const Parameter& parameter : function.parameters) {
    const std::string name = parameter.symbol->getName().c_str();
    parameter_names_.push_back(name.empty() ? "" : take_name(*parameter.symbol));
  }
}

std::string CppFunction::take_name(const TIntermSymbol& symbol) {
  const std::string name = names_.take(context_.local(symbol));
  scope_.locals[symbol.getId()] = name;
  return name;
}

std::string CppFunction::signature() {
  const std::string first = first_parameter();
  std::string text = result_type() + " " + context_.function(function_.name) + "(" + first;
  for (std::size_t i = 0; i < function_.parameters.size(); ++i) {
    const Parameter& parameter = function_.parameters[i];
    text += (i > 0 || !first.empty() ? ", " : "") +
            context_.type(parameter.symbol->getType(), varies(*parameter.symbol)) +
            (parameter.is_out ? "&" : "");
    if (!parameter_names_[i].empty()) text += ' ' + parameter_names_[i];
  }
  return text + ")";
}

std::vector<CppLine> CppFunction::lines(const std::string& specifier) {
  at(*function_.definition);
  out_.begin(specifier + signature());
  if (context_.options().checks) out_.statement("const Caller__ caller__(*this)");
  reset_out_parameters();
  begin();
  if (function_.body != nullptr) block(*function_.body);
  end();
  out_.end();
  return out_.take();
}

std::string CppFunction::result_type() const {
  return context_.type(function_.definition->getType());
}

bool CppFunction::ends_with_jump() const {
  const TIntermSequence* statements = function_.body != nullptr ? &function_.body->getSequence() : nullptr;
  return statements != nullptr && !statements->empty() && statements->back() != nullptr &&
         statements->back()->getAsBranchNode() != nullptr;
}

void CppFunction::end() {
  if (function_.definition->getBasicType() != EbtVoid && !ends_with_jump()) out_.statement("return {}");
}

void CppFunction::reset_out_parameter(const std::string& name) {
  out_.statement("unwritten(" + name + ")");
}

// What a function leaves unwritten is undefined in GLSL; it must not be what the caller's variable held.
void CppFunction::reset_out_parameters() {
  for (std::size_t i = 0; i < function_.parameters.size(); ++i) {
    const Parameter& parameter = function_.parameters[i];
    if (!parameter.is_out || parameter.is_inout || parameter_names_[i].empty()) continue;
    // Not needed where the first statement writes all of it.
    const TIntermNode* first = function_.body != nullptr && !function_.body->getSequence().empty()
                                   ? function_.body->getSequence()[0]
                                   : nullptr;
    const TIntermBinary* assignment = first != nullptr ? first->getAsBinaryNode() : nullptr;
    const TIntermSymbol* written = assignment != nullptr && assignment->getOp() == EOpAssign
                                       ? assignment->getLeft()->getAsSymbolNode()
                                       : nullptr;
    const SymbolId id = parameter.symbol->getId();
    if (written != nullptr && written->getId() == id &&
        context_.program().effects(*assignment->getRight()).reads.count(id) == 0)
      continue;
    reset_out_parameter(parameter_names_[i]);
  }
}

void CppFunction::at(const TIntermNode& node) {
  if (context_.program().tree().token_of(node) >= 0) out_.at(context_.program().tree().line_of(node));
}

std::string CppFunction::mark() const {
  const SourceLine& source = out_.source();
  if (!context_.options().checks || source.file < 0) return {};
  return "mark__(" + std::to_string(source.file) + ", " + std::to_string(source.line) + ")";
}

bool CppFunction::watches(const TType& type) const {
  if (context_.options().shadows) return is_plain_value(type) && type.getBasicType() == EbtFloat;
  return context_.options().checks && is_plain_value(type);
}

std::string CppFunction::watch_arguments() {
  if (!context_.options().shadows) return {};
  return std::to_string(context_.places().of_line(out_.source())) + ", ";
}

void CppFunction::watch(const TType& type, const std::string& text) {
  if (watches(type)) out_.statement("watch__(" + watch_arguments() + text + ")");
}

void CppFunction::watch(const TIntermTyped& left) {
  if (!watches(left.getType()) || context_.program().effects(left).writes_any()) return;
  std::string text;
  if (out_.capture([&] { text = expressions_.value(left).text; }).empty()) watch(left.getType(), text);
}

std::string CppFunction::take_block_name(const std::string& wanted) {
  block_names_.push_back(names_.take(wanted));
  return block_names_.back();
}

void CppFunction::declare(const TIntermSymbol& symbol) {
  const std::string name = take_name(symbol);
  block_names_.push_back(name);
  out_.statement(context_.type(symbol.getType(), varies(symbol)) + " " + name +
                 (context_.options().initialise_locals ? "{}" : ""));
}

// Declares what `block` declares before statement `index`, but leaves to the statement what its assignment
// can declare.
void CppFunction::declare(const Block& block, int index) {
  const TIntermNode* node = block.getSequence()[index];
  std::vector<const TIntermNode*> parts = {node};
  if (node != nullptr && is_declaration_list(context_.program().tree(), *node)) {
    const TIntermSequence& list = node->getAsAggregate()->getSequence();
    parts.assign(list.begin(), list.end());
  }
  for (const TIntermSymbol* symbol : placement_.declared_at(block, index)) {
    const auto assigns = [&](const TIntermNode* part) {
      const TIntermBinary* assignment = part != nullptr ? part->getAsBinaryNode() : nullptr;
      if (assignment == nullptr || assignment->getOp() != EOpAssign) return false;
      const TIntermSymbol* left = assignment->getLeft()->getAsSymbolNode();
      return left != nullptr && left->getId() == symbol->getId() &&
             context_.program().effects(*assignment->getRight()).reads.count(symbol->getId()) == 0;
    };
    // Its first use has to be the assignment.
    const auto uses = [&](const TIntermNode* part) {
      return part != nullptr && context_.program().effects(*part).reads.count(symbol->getId()) != 0;
    };
    const auto first = std::find_if(parts.begin(), parts.end(), uses);
    if (first != parts.end() && assigns(*first))
      pending_.insert(symbol->getId());
    else
      declare(*symbol);
  }
}

void CppFunction::statement_or_list(const TIntermNode& node) {
  if (!is_declaration_list(context_.program().tree(), node)) return statement(&node);
  for (const TIntermNode* declaration : node.getAsAggregate()->getSequence()) statement(declaration);
}

void CppFunction::block(const Block& block) {
  with_own_names([&] {
    const TIntermSequence& statements = block.getSequence();
    for (int i = 0; i < static_cast<int>(statements.size()); ++i) {
      if (statements[i] == nullptr) continue;
      at(*statements[i]);
      declare(block, i);
      statement_or_list(*statements[i]);
      after(*statements[i]);
    }
  });
}

void CppFunction::statements(const TIntermNode* node) {
  const TIntermAggregate* sequence = node != nullptr ? node->getAsAggregate() : nullptr;
  if (sequence != nullptr && sequence->getOp() == EOpSequence &&
      !is_for_loop(context_.program().tree(), *sequence))
    block(*sequence);
  else
    statement(node);
}

void CppFunction::statement(const TIntermNode* node) {
  if (node == nullptr) return;
  at(*node);
  const TIntermAggregate* sequence = node->getAsAggregate();
  if (sequence != nullptr && sequence->getOp() == EOpSequence) {
    if (is_for_loop(context_.program().tree(), *sequence))
      return control(*sequence->getSequence().back(), sequence);
    out_.begin();
    block(*sequence);
    return out_.end();
  }
  if (const std::string place = mark(); !place.empty()) out_.statement(place);
  if (const TIntermBranch* branch = node->getAsBranchNode()) return jump(*branch);
  const TIntermTyped* typed = node->getAsTyped();  // `?:` is a selection with a type
  if (typed != nullptr && (node->getAsSelectionNode() == nullptr || typed->getBasicType() != EbtVoid))
    expression_statement(*typed);
  else
    control(*node, nullptr);
}

void CppFunction::control(const TIntermNode& node, const Block* wrapper) {
  if (const TIntermLoop* repeated = node.getAsLoopNode())
    loop(*repeated, wrapper);
  else if (const TIntermSelection* choice = node.getAsSelectionNode())
    selection(*choice);
  else
    switch_statement(*node.getAsSwitchNode());
}

void CppFunction::expression_statement(const TIntermTyped& node) {
  const TIntermBinary* assignment = node.getAsBinaryNode();
  if (assignment != nullptr && assignment->getOp() == EOpAssign) {
    const TIntermSymbol* left = assignment->getLeft()->getAsSymbolNode();
    if (left != nullptr && pending_.erase(left->getId()) != 0)
      return initialise(*left, *assignment->getRight());
  }
  expressions_.statement(node);
  if (assignment != nullptr && assignment_operator(assignment->getOp()).sign != nullptr)
    watch(*assignment->getLeft());
}

void CppFunction::initialise(const TIntermSymbol& symbol, const TIntermTyped& value) {
  at(symbol);
  const Expression text = expressions_.value(value, varies(symbol));
  const std::string name = take_name(symbol);
  block_names_.push_back(name);
  out_.declare(context_.type(symbol.getType(), varies(symbol)), name, text.text);
  watch(symbol.getType(), name);
}

void CppFunction::jump(const TIntermBranch& node) {
  switch (node.getFlowOp()) {
    case EOpKill:
      return out_.statement("stop_invocation__()");
    case EOpBreak:
      return out_.statement("break");
    case EOpContinue:
      return out_.statement("continue");
    default:
      break;
  }
  if (node.getExpression() == nullptr) return out_.statement("return");
  std::string text = expressions_.value(*node.getExpression()).text;
  const TType& type = node.getExpression()->getType();
  if (watches(type)) text = "watched__<" + context_.type(type) + ">(" + watch_arguments() + text + ")";
  out_.statement("return " + text);
}

void CppFunction::selection(const TIntermSelection& node) {
  const Expression condition = expressions_.value(*node.getCondition());
  out_.begin("if (" + condition.text + ")");
  statements(node.getTrueBlock());
  if (node.getFalseBlock() != nullptr) {
    out_.next("else");
    statements(node.getFalseBlock());
  }
  out_.end();
}

void CppFunction::switch_statement(const TIntermSwitch& node) {
  const Expression value = expressions_.value(*node.getCondition()->getAsTyped());
  out_.begin("switch (" + value.text + ")");
  bool in_group = false;
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    if (part == nullptr) continue;
    const TIntermBranch* label = part->getAsBranchNode();
    const bool is_case = label != nullptr && label->getFlowOp() == EOpCase;
    if (is_case || (label != nullptr && label->getFlowOp() == EOpDefault)) {
      if (in_group) out_.statement("[[fallthrough]]");
      in_group = false;
      at(*part);
      out_.line(is_case ? "case " + expressions_.value(*label->getExpression()).text + ":" : "default:");
    } else {
      out_.begin();
      statements(part);
      out_.end();
      in_group = true;
    }
  }
  if (!in_group) out_.line(";");
  out_.end();
}

void CppFunction::declare_loop_variables(const Block& wrapper) {
  const TIntermSequence& parts = wrapper.getSequence();
  const int last = static_cast<int>(parts.size()) - 1;
  for (int i = 0; i < last; ++i) {
    if (parts[i] == nullptr) continue;
    declare(wrapper, i);
    statement_or_list(*parts[i]);
  }
  declare(wrapper, last);
}

void CppFunction::loop(const TIntermLoop& node, const Block* wrapper) {
  with_own_names([&] {
    const SourceLine start = out_.source();
    const std::vector<CppLine> setup = out_.capture([&] {
      if (wrapper != nullptr) declare_loop_variables(*wrapper);
    });
    out_.at(start);
    // What stands in front of the loop becomes its initialiser if C++ has room for it; the rest needs braces.
    const std::optional<std::string> initialiser =
        context_.options().checks && !setup.empty() ? std::nullopt : joined(setup);
    if (initialiser) return loop(node, *initialiser);
    out_.begin();
    out_.add(setup);
    loop(node, "");
    out_.end();
  });
}

void CppFunction::loop(const TIntermLoop& node, const std::string& initialiser) {
  std::string test = node.getTest() != nullptr ? expressions_.self_contained(*node.getTest()) : "";
  if (const std::string place = mark(); !place.empty() && !test.empty())
    test = "(" + place + ", " + test + ")";
  const SourceLine start = out_.source();
  if (!node.testFirst()) {
    out_.begin("do");
  } else if (context_.program().tree().token_text(node) == "for") {
    const std::string terminal =
        node.getTerminal() != nullptr ? expressions_.self_contained_statement(*node.getTerminal()) : "";
    out_.begin("for (" + initialiser + ";" + (test.empty() ? "" : " " + test) + ";" +
               (terminal.empty() ? "" : " " + terminal) + ")");
  } else {
    out_.begin("while (" + test + ")");
  }
  begin_round();
  loop_body(node);
  if (node.testFirst()) return out_.end();
  out_.at(start);
  out_.end("} while (" + test + ");");
}

void CppFunction::begin_round() {
  if (context_.options().loop_guards) out_.statement("loop_guard__()");
  if (context_.options().checks || context_.options().shadows)
    out_.statement("if (round__()) stop_invocation__()");
}

void CppFunction::loop_body(const TIntermLoop& node) {
  statements(node.getBody());
}

}  // namespace shadertwin::emit
