#include "reference/emit/cpp_function.h"

#include <algorithm>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

// `int i = 0;` and `int j = 1;` as `int i = 0, j = 1`; empty if the lines can't be one declaration.
std::string joined_initialisers(const std::vector<CppLine>& lines) {
  std::string text;
  std::string type;
  for (const CppLine& line : lines) {
    const std::string statement = line.text.substr(0, line.text.size() - 1);
    if (text.empty()) {
      text = statement;
      type = statement.substr(0, statement.find(' ') + 1);
    } else if (lines.front().text.find(" = ") != std::string::npos && statement.rfind(type, 0) == 0 &&
               type.find('<') == std::string::npos && statement.find(' ', type.size()) != std::string::npos &&
               text.compare(type.size(), 2, "= ") != 0) {
      text += ", " + statement.substr(type.size());
    } else {
      return {};
    }
  }
  return text;
}

// What twin::Checks can look at.
bool is_plain_value(const TType& type) {
  return !type.isArray() && !type.isStruct() && type.getBasicType() != EbtVoid;
}

}  // namespace

CppFunction::CppFunction(CppContext& context, const Function& function)
    : CppFunction(context, function,
                  [&](NameScope& names) { return std::make_unique<CppExpressions>(context, names); }) {}

CppFunction::CppFunction(CppContext& context, const Function& function,
                         const std::function<std::unique_ptr<CppExpressions>(NameScope&)>& make_expressions)
    : context_(context),
      function_(function),
      placement_(context.program(), function),
      expressions_(make_expressions(names_)) {
  // A local variable must not hide what this function needs.
  for (const std::string& name : function.calls)
    names_.reserve(context.function(name.substr(0, name.find('('))));
  for (const std::string& name : function.builtins) names_.reserve(context.builtin(name));
  for (const StructTable::Entry& entry : context.structs().entries()) names_.reserve(entry.name);
  for (const TIntermSymbol* symbol : context.program().globals()) names_.reserve(context.global(*symbol));
  for (const Parameter& parameter : function.parameters) {
    const std::string name = parameter.symbol->getName().c_str();
    parameter_names_.push_back(name.empty() ? "" : take_name(*parameter.symbol));
  }
}

std::string CppFunction::take_name(const TIntermSymbol& symbol) {
  const std::string name = names_.take(cpp_name(symbol.getName().c_str()));
  expressions_->name_local(symbol.getId(), name);
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

std::vector<CppLine> CppFunction::lines() {
  at(*function_.definition);
  line(signature() + " {");
  ++depth_;
  if (context_.options().checks) line("const Caller__ caller__(*this);");
  reset_out_parameters();
  begin();
  if (function_.body != nullptr) block(*function_.body);
  end();
  --depth_;
  line("}");
  return std::move(lines_);
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
  if (function_.definition->getBasicType() != EbtVoid && !ends_with_jump()) line("return {};");
}

void CppFunction::reset_out_parameter(const std::string& name) {
  line("unwritten(" + name + ");");
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
  if (context_.program().tree().token_of(node) >= 0) source_ = context_.program().tree().line_of(node);
}

void CppFunction::line(const std::string& text) {
  lines_.push_back({depth_, text, source_});
}

void CppFunction::prelude() {
  for (const std::string& text : expressions_->take_prelude()) line(text);
}

std::string CppFunction::mark() const {
  if (!context_.options().checks || source_.file < 0) return {};
  return "mark__(" + std::to_string(source_.file) + ", " + std::to_string(source_.line) + ")";
}

void CppFunction::watch(const TType& type, const std::string& text) {
  if (context_.options().checks && is_plain_value(type)) line("watch__(" + text + ");");
}

void CppFunction::watch(const TIntermTyped& left) {
  if (!context_.options().checks || !is_plain_value(left.getType()) ||
      context_.program().effects(left).writes_any())
    return;
  const std::string text = expressions_->value(left);
  if (expressions_->take_prelude().empty()) watch(left.getType(), text);
}

bool CppFunction::is_pending(const TIntermSymbol& symbol) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const TIntermSymbol* other) { return other->getId() == symbol.getId(); });
}

void CppFunction::declare(const TIntermSymbol& symbol) {
  const std::string name = take_name(symbol);
  block_names_.push_back(name);
  line(context_.type(symbol.getType(), varies(symbol)) + " " + name +
       (context_.options().initialise_locals ? "{};" : ";"));
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
      pending_.push_back(symbol);
    else
      declare(*symbol);
  }
}

void CppFunction::block(const Block& block) {
  const std::vector<std::string> outer = std::exchange(block_names_, {});
  const TIntermSequence& statements = block.getSequence();
  for (int i = 0; i < static_cast<int>(statements.size()); ++i) {
    if (statements[i] == nullptr) continue;
    if (context_.program().tree().token_of(*statements[i]) >= 0) at(*statements[i]);
    declare(block, i);
    if (is_declaration_list(context_.program().tree(), *statements[i])) {
      for (const TIntermNode* declaration : statements[i]->getAsAggregate()->getSequence())
        statement(declaration);
    } else {
      statement(statements[i]);
    }
    after(*statements[i]);
  }
  for (const std::string& name : block_names_) names_.give_back(name);
  block_names_ = outer;
}

void CppFunction::scoped(const TIntermNode* node) {
  ++depth_;
  if (node != nullptr) {
    const TIntermAggregate* sequence = node->getAsAggregate();
    if (sequence != nullptr && sequence->getOp() == EOpSequence &&
        !is_for_loop(context_.program().tree(), *sequence))
      block(*sequence);
    else
      statement(node);
  }
  --depth_;
}

void CppFunction::statement(const TIntermNode* node) {
  if (node == nullptr) return;
  at(*node);
  const TIntermAggregate* group = node->getAsAggregate();
  const bool is_group = group != nullptr && group->getOp() == EOpSequence;
  if (const std::string place = mark(); !place.empty() && !is_group) line(place + ";");
  if (const TIntermLoop* repeated = node->getAsLoopNode()) return loop(*repeated, "");
  if (const TIntermSelection* choice = node->getAsSelectionNode();
      choice != nullptr && choice->getBasicType() == EbtVoid)
    return selection(*choice);
  if (const TIntermSwitch* choice = node->getAsSwitchNode()) return switch_statement(*choice);
  if (const TIntermBranch* jump = node->getAsBranchNode()) return branch(*jump);
  const TIntermAggregate* sequence = node->getAsAggregate();
  if (sequence != nullptr && sequence->getOp() == EOpSequence) {
    if (is_for_loop(context_.program().tree(), *sequence)) return for_loop(*sequence);
    line("{");
    ++depth_;
    block(*sequence);
    --depth_;
    line("}");
    return;
  }
  if (const TIntermTyped* typed = node->getAsTyped()) expression_statement(*typed);
}

void CppFunction::expression_statement(const TIntermTyped& node) {
  if (const TIntermBinary* assignment = node.getAsBinaryNode();
      assignment != nullptr && assignment->getOp() == EOpAssign) {
    const TIntermSymbol* left = assignment->getLeft()->getAsSymbolNode();
    if (left != nullptr && is_pending(*left)) return initialise(*left, *assignment->getRight());
  }
  const std::string text = expressions_->statement(node);
  prelude();
  if (!text.empty()) line(text + ";");
  if (const TIntermBinary* assignment = node.getAsBinaryNode();
      assignment != nullptr && assignment_operator(assignment->getOp()).sign != nullptr)
    watch(*assignment->getLeft());
}

void CppFunction::initialise(const TIntermSymbol& symbol, const TIntermTyped& value) {
  at(symbol);
  const std::string text = expressions_->value(value, varies(symbol));
  prelude();
  const std::string name = take_name(symbol);
  block_names_.push_back(name);
  pending_.erase(std::find_if(pending_.begin(), pending_.end(),
                              [&](const TIntermSymbol* other) { return other->getId() == symbol.getId(); }));
  line(context_.type(symbol.getType(), varies(symbol)) + " " + name + " = " + text + ";");
  watch(symbol.getType(), name);
}

void CppFunction::branch(const TIntermBranch& node) {
  const auto label_value = [&] { return expressions_->value(*node.getExpression()); };
  switch (node.getFlowOp()) {
    case EOpKill:
      return line("stop_invocation();");
    case EOpBreak:
      return line("break;");
    case EOpContinue:
      return line("continue;");
    case EOpCase:
      return line("case " + label_value() + ":");
    case EOpDefault:
      return line("default:");
    default:
      break;
  }
  if (node.getExpression() == nullptr) return line("return;");
  std::string text = expressions_->value(*node.getExpression());
  prelude();
  const TType& type = node.getExpression()->getType();
  if (context_.options().checks && is_plain_value(type))
    text = "watched__<" + context_.type(type) + ">(" + text + ")";
  line("return " + text + ";");
}

void CppFunction::selection(const TIntermSelection& node) {
  const std::string condition = expressions_->value(*node.getCondition());
  prelude();
  line("if (" + condition + ") {");
  scoped(node.getTrueBlock());
  if (node.getFalseBlock() != nullptr) {
    line("} else {");
    scoped(node.getFalseBlock());
  }
  line("}");
}

void CppFunction::switch_statement(const TIntermSwitch& node) {
  const std::string value = expressions_->value(*node.getCondition()->getAsTyped());
  prelude();
  line("switch (" + value + ") {");
  ++depth_;
  bool in_group = false;
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    if (part == nullptr) continue;
    const TIntermBranch* jump = part->getAsBranchNode();
    if (jump != nullptr && (jump->getFlowOp() == EOpCase || jump->getFlowOp() == EOpDefault)) {
      if (in_group) line("[[fallthrough]];");
      in_group = false;
      at(*part);
      branch(*jump);
    } else {
      line("{");
      scoped(part);
      line("}");
      in_group = true;
    }
  }
  if (!in_group) line(";");
  --depth_;
  line("}");
}

void CppFunction::declare_loop_variables(const Block& wrapper) {
  const TIntermSequence& parts = wrapper.getSequence();
  for (int i = 0; i + 1 < static_cast<int>(parts.size()); ++i) {
    if (parts[i] == nullptr) continue;
    declare(wrapper, i);
    if (is_declaration_list(context_.program().tree(), *parts[i])) {
      for (const TIntermNode* declaration : parts[i]->getAsAggregate()->getSequence()) statement(declaration);
    } else {
      statement(parts[i]);
    }
  }
  declare(wrapper, static_cast<int>(parts.size()) - 1);
}

void CppFunction::for_loop(const Block& wrapper) {
  const std::vector<std::string> outer = std::exchange(block_names_, {});
  const TIntermSequence& parts = wrapper.getSequence();
  const SourceLine start = source_;
  line("{");
  ++depth_;
  const std::size_t first_line = lines_.size();
  declare_loop_variables(wrapper);
  const TIntermLoop& repeated = *parts.back()->getAsLoopNode();
  // What stands in front of the loop becomes its initialiser if C++ has room for it; the rest needs the
  // braces.
  const std::size_t written = lines_.size() - first_line;
  source_ = start;
  std::string initialiser =
      context_.options().checks
          ? ""
          : joined_initialisers({lines_.begin() + static_cast<std::ptrdiff_t>(first_line), lines_.end()});
  if (written == 0 || !initialiser.empty()) {
    lines_.resize(first_line - 1);
    --depth_;
    loop(repeated, initialiser);
  } else {
    loop(repeated, "");
    --depth_;
    line("}");
  }
  for (const std::string& name : block_names_) names_.give_back(name);
  block_names_ = outer;
}

void CppFunction::loop(const TIntermLoop& node, const std::string& initialiser) {
  std::string test = node.getTest() != nullptr ? expressions_->self_contained(*node.getTest()) : "";
  if (const std::string place = mark(); !place.empty() && !test.empty())
    test = "(" + place + ", " + test + ")";
  const auto begin_round = [&] {
    if (context_.options().loop_guards) line("  loop_guard();");
    if (context_.options().checks) line("  if (round__()) stop_invocation();");
  };
  const SourceLine start = source_;
  if (!node.testFirst()) {
    line("do {");
    begin_round();
    scoped(node.getBody());
    source_ = start;
    line("} while (" + test + ");");
    return;
  }
  const bool is_for = context_.program().tree().token_text(node) == "for";
  if (is_for) {
    const std::string terminal =
        node.getTerminal() != nullptr ? expressions_->self_contained_statement(*node.getTerminal()) : "";
    line("for (" + initialiser + ";" + (test.empty() ? "" : " " + test) + ";" +
         (terminal.empty() ? "" : " " + terminal) + ") {");
  } else {
    line("while (" + test + ") {");
  }
  begin_round();
  scoped(node.getBody());
  line("}");
}

}  // namespace shadertwin::emit
