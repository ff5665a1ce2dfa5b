#include "reference/emit/program.h"

#include <algorithm>

#include "host/base/error.h"
#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

std::string plain_name(const std::string& mangled) {
  return mangled.substr(0, mangled.find('('));
}

bool intersect(const std::set<SymbolId>& a, const std::set<SymbolId>& b) {
  return std::any_of(a.begin(), a.end(), [&](SymbolId id) { return b.count(id) != 0; });
}

// What a node and everything below it does, without what called functions do to globals.
class OwnEffects : public TIntermTraverser {
 public:
  explicit OwnEffects(const Program& program) : program_(program) {}

  Effects effects;

  void visitSymbol(TIntermSymbol* symbol) override { effects.reads.insert(symbol->getId()); }

  bool visitBinary(TVisit, TIntermBinary* node) override {
    if (assignment_operator(node->getOp()).sign != nullptr) write(*node->getLeft());
    return true;
  }

  bool visitUnary(TVisit, TIntermUnary* node) override {
    if (is_increment(node->getOp())) write(*node->getOperand());
    return true;
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() == EOpModf) write(*node->getSequence()[1]->getAsTyped());
    if (node->getOp() != EOpFunctionCall) return true;
    const TQualifierList& qualifiers = node->getQualifierList();
    for (std::size_t i = 0; i < node->getSequence().size(); ++i) {
      if (is_out(qualifiers[i])) write(*node->getSequence()[i]->getAsTyped());
    }
    effects.add(program_.function(*node).globals);
    return true;
  }

  bool visitBranch(TVisit, TIntermBranch* node) override {
    if (node->getFlowOp() == EOpKill) effects.writes.insert(Program::control_flow);
    return true;
  }

 private:
  void write(const TIntermTyped& lvalue) {
    if (const TIntermSymbol* symbol = base_symbol(lvalue)) effects.writes.insert(symbol->getId());
  }

  const Program& program_;
};

// The parts of a function that its summary needs.
class FunctionSummary : public TIntermTraverser {
 public:
  explicit FunctionSummary(Function& function) : function_(function) {}

  bool uses_derivatives = false;
  bool uses_implicit_lod = false;
  std::map<std::string, const TIntermAggregate*> first_call;

  bool visitUnary(TVisit, TIntermUnary* node) override { return note(node->getOp()); }
  bool visitBinary(TVisit, TIntermBinary*) override { return true; }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() == EOpFunctionCall) {
      function_.calls.insert(plain_name(node->getName().c_str()));
      first_call.emplace(node->getName().c_str(), node);
      return true;
    }
    return note(node->getOp());
  }

  bool visitBranch(TVisit, TIntermBranch* node) override {
    function_.discards |= node->getFlowOp() == EOpKill;
    return true;
  }

 private:
  bool note(TOperator op) {
    if (const char* name = builtin_name(op)) function_.builtins.insert(name);
    uses_derivatives |= is_derivative(op);
    uses_implicit_lod |= has_implicit_lod(op);
    return true;
  }

  Function& function_;
};

}  // namespace

void Effects::add(const Effects& other) {
  reads.insert(other.reads.begin(), other.reads.end());
  writes.insert(other.writes.begin(), other.writes.end());
}

bool Effects::conflicts_with(const Effects& other) const {
  return intersect(writes, other.reads) || intersect(writes, other.writes) || intersect(reads, other.writes);
}

bool is_out(TStorageQualifier qualifier) {
  return qualifier == EvqOut || qualifier == EvqInOut;
}

const TIntermSymbol* base_symbol(const TIntermTyped& lvalue) {
  const TIntermTyped* node = &lvalue;
  while (const TIntermBinary* binary = node->getAsBinaryNode()) node = binary->getLeft();
  return node->getAsSymbolNode();
}

Program::Program(const SyntaxTree& tree) : tree_(tree) {
  for (const TIntermNode* node : tree.root().getSequence()) collect(*node);
  resolve_calls();
}

void Program::collect(const TIntermNode& node) {
  if (const TIntermBinary* binary = node.getAsBinaryNode()) {
    initialisers_.push_back(binary);
    return;
  }
  const TIntermAggregate* aggregate = node.getAsAggregate();
  if (aggregate == nullptr) return;
  if (aggregate->getOp() == EOpFunction) {
    add_function(*aggregate);
  } else if (aggregate->getOp() == EOpLinkerObjects) {
    for (const TIntermNode* object : aggregate->getSequence()) {
      if (const TIntermSymbol* symbol = object->getAsSymbolNode()) {
        globals_.push_back(symbol);
        global_ids_.insert(symbol->getId());
      }
    }
  } else if (aggregate->getOp() == EOpSequence) {
    for (const TIntermNode* child : aggregate->getSequence()) collect(*child);
  }
}

void Program::add_function(const TIntermAggregate& definition) {
  Function function;
  function.mangled_name = definition.getName().c_str();
  function.name = plain_name(function.mangled_name);
  function.definition = &definition;
  const TIntermSequence& parts = definition.getSequence();
  for (const TIntermNode* node : parts[0]->getAsAggregate()->getSequence()) {
    const TIntermSymbol* symbol = node->getAsSymbolNode();
    const TStorageQualifier storage = symbol->getQualifier().storage;
    function.parameters.push_back({symbol, is_out(storage), storage == EvqInOut});
  }
  if (parts.size() > 1) function.body = parts[1]->getAsAggregate();
  function_index_[function.mangled_name] = static_cast<int>(functions_.size());
  functions_.push_back(std::move(function));
}

void Program::resolve_calls() {
  std::vector<std::map<std::string, const TIntermAggregate*>> first_calls;
  for (Function& function : functions_) {
    FunctionSummary summary(function);
    const_cast<TIntermAggregate*>(function.definition)->traverse(&summary);  // it has no const traversal
    uses_derivatives_ |= summary.uses_derivatives;
    uses_implicit_lod_ |= summary.uses_implicit_lod;
    first_calls.push_back(summary.first_call);
  }

  enum class State { untouched, active, done };
  std::vector<State> state(functions_.size(), State::untouched);
  const auto visit = [&](const auto& self, int index) -> void {
    Function& function = functions_[index];
    state[index] = State::active;
    for (const auto& [name, call] : first_calls[index]) {
      const auto callee = function_index_.find(name);
      if (callee == function_index_.end())
        throw Error(ExitStatus::shader,
                    tree_.place_of(*call) + ": error: '" + plain_name(name) + "' is called but not defined");
      if (state[callee->second] == State::active)
        throw Error(ExitStatus::shader, tree_.place_of(*call) + ": error: '" + plain_name(name) +
                                            "' calls itself: recursion is not allowed");
      if (state[callee->second] == State::untouched) self(self, callee->second);
    }
    OwnEffects own(*this);
    const_cast<TIntermAggregate*>(function.definition)->traverse(&own);
    for (const SymbolId id : own.effects.reads) {
      if (is_global(id)) function.globals.reads.insert(id);
    }
    for (const SymbolId id : own.effects.writes) {
      if (is_global(id) || id == control_flow) function.globals.writes.insert(id);
    }
    state[index] = State::done;
  };
  for (int i = 0; i < static_cast<int>(functions_.size()); ++i) {
    if (state[i] == State::untouched) visit(visit, i);
  }
}

const Function& Program::function(const TIntermAggregate& call) const {
  return functions_[function_index_.at(call.getName().c_str())];
}

const Effects& Program::effects(const TIntermNode& node) const {
  const auto found = effects_.find(&node);
  if (found != effects_.end()) return found->second;
  OwnEffects own(*this);
  const_cast<TIntermNode&>(node).traverse(&own);
  return effects_.emplace(&node, std::move(own.effects)).first->second;
}

bool Program::uses_discard() const {
  return std::any_of(functions_.begin(), functions_.end(), [](const Function& f) { return f.discards; });
}

}  // namespace shadertwin::emit
