#include "reference/emit/uniformity.h"

#include <memory>
#include <vector>

#include "reference/emit/cpp_context.h"
#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

class JumpFinder : public TIntermTraverser {
 public:
  JumpFinder(const Program& program, const Uniformity& uniformity)
      : program_(program), uniformity_(uniformity) {}

  bool found = false;

  bool visitBranch(TVisit, TIntermBranch* node) override {
    const TOperator op = node->getFlowOp();
    found |= op == EOpKill || op == EOpBreak || op == EOpContinue || op == EOpReturn;
    return true;
  }
  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() == EOpFunctionCall) found |= uniformity_.discards(program_.function(*node));
    return true;
  }

 private:
  const Program& program_;
  const Uniformity& uniformity_;
};

// A rough count of instructions.
class CostCounter : public TIntermTraverser {
 public:
  int cost = 0;

  bool visitBinary(TVisit, TIntermBinary*) override { return add(1); }
  bool visitSelection(TVisit, TIntermSelection*) override { return add(1); }
  bool visitUnary(TVisit, TIntermUnary* node) override { return add(node->getOp() >= EOpRadians ? 6 : 1); }
  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() == EOpFunctionCall || reads_texture(node->getOp())) return add(1000);
    if (is_constructor(node->getOp())) return true;
    return add(6);
  }

 private:
  bool add(int count) {
    cost += count;
    return true;
  }
};

}  // namespace

bool is_costly(const TIntermNode& node) {
  CostCounter counter;
  const_cast<TIntermNode&>(node).traverse(&counter);  // it has no const traversal
  return counter.cost > 24;
}

// One walk over the program under what is known so far.
class UniformityPass {
 public:
  UniformityPass(Uniformity& known, const std::map<const Function*, std::unique_ptr<Placement>>& placements)
      : known_(known), program_(known.program_), placements_(placements) {}

  // Whether something new was found.
  bool run() {
    known_.masked_.clear();  // found anew each time; it only grows
    for (const Function& function : program_.functions()) walk(function);
    return changed_;
  }

 private:
  struct LoopFrame {
    const TIntermNode* loop;  // null: a switch
    int outside;              // the region around it
  };

  void walk(const Function& function) {
    function_ = &function;
    placement_ = placements_.at(&function).get();
    parents_ = {-1};
    region_ = 0;
    loops_.clear();
    for (const Parameter& parameter : function.parameters) {
      declared_[parameter.symbol->getId()] = 0;
      if (parameter.is_out || parameter.symbol->getType().isStruct() || parameter.symbol->getType().isArray())
        make_varying(*parameter.symbol);
      if (parameter.is_out) out_parameters_.insert(parameter.symbol->getId());
    }
    if (function.body != nullptr) block(*function.body);
  }

  template <class Key>
  void insert(std::set<Key>& known, Key key) {
    changed_ |= known.insert(key).second;
  }
  void make_varying(const TIntermSymbol& symbol) {
    insert(known_.varying_symbols_, SymbolId(symbol.getId()));
  }
  void make_divergent(const TIntermNode& node) { insert(known_.divergent_, &node); }

  int new_region() {
    parents_.push_back(region_);
    return static_cast<int>(parents_.size()) - 1;
  }
  bool contains(int outer, int inner) const {
    while (inner > outer) inner = parents_[static_cast<std::size_t>(inner)];
    return inner == outer;
  }
  template <class F>
  void within(int region, const F& walk) {
    const int before = std::exchange(region_, region);
    walk();
    region_ = before;
  }

  void block(const Block& block) {
    const TIntermSequence& statements = block.getSequence();
    for (int i = 0; i < static_cast<int>(statements.size()); ++i) {
      if (statements[i] == nullptr) continue;
      for (const TIntermSymbol* symbol : placement_->declared_at(block, i))
        declared_[symbol->getId()] = region_;
      statement(statements[i]);
    }
  }

  void statement(const TIntermNode* node) {
    if (node == nullptr) return;
    if (const TIntermLoop* repeated = node->getAsLoopNode()) return loop(*repeated, nullptr);
    if (const TIntermSelection* choice = node->getAsSelectionNode()) return selection(*choice);
    if (const TIntermSwitch* choice = node->getAsSwitchNode()) return switch_statement(*choice);
    if (const TIntermBranch* jump = node->getAsBranchNode()) return branch(*jump);
    if (const TIntermAggregate* sequence = node->getAsAggregate();
        sequence != nullptr && sequence->getOp() == EOpSequence) {
      if (is_for_loop(program_.tree(), *sequence))
        return loop(*sequence->getSequence().back()->getAsLoopNode(), sequence);
      return block(*sequence);
    }
    if (const TIntermTyped* typed = node->getAsTyped()) expression(*typed);
  }

  // `if` and `?:`.
  void selection(const TIntermSelection& node) {
    expression(*node.getCondition());
    const bool diverges = known_.varies(*node.getCondition());
    if (diverges) make_divergent(node);
    for (const TIntermNode* side : {node.getTrueBlock(), node.getFalseBlock()})
      within(diverges ? new_region() : region_, [&] { statement(side); });
  }

  void switch_statement(const TIntermSwitch& node) {
    expression(*node.getCondition()->getAsTyped());
    make_divergent(node);
    loops_.push_back({nullptr, region_});
    for (const TIntermNode* group : node.getBody()->getSequence()) {
      if (group == nullptr) continue;
      const TIntermBranch* label = group->getAsBranchNode();
      if (label != nullptr && (label->getFlowOp() == EOpCase || label->getFlowOp() == EOpDefault)) continue;
      within(new_region(), [&] { statement(group); });
    }
    loops_.pop_back();
  }

  void loop(const TIntermLoop& node, const Block* wrapper) {
    const int outside = region_;
    const int header = known_.diverges(node) ? new_region() : outside;
    if (wrapper != nullptr) {
      // What the loop's own variables start with is set before any pixel has left.
      const TIntermSequence& parts = wrapper->getSequence();
      for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
        if (parts[i] == nullptr) continue;
        for (const TIntermSymbol* symbol : placement_->declared_at(*wrapper, i))
          declared_[symbol->getId()] = header;
        if (i + 1 < static_cast<int>(parts.size())) statement(parts[i]);
      }
    }
    within(header, [&] {
      if (node.getTest() != nullptr) expression(*node.getTest());
      if (node.getTerminal() != nullptr) expression(*node.getTerminal());
      loops_.push_back({&node, outside});
      const bool own_body = header != outside || known_.diverges_in_body(node);
      within(own_body ? new_region() : region_, [&] { statement(node.getBody()); });
      loops_.pop_back();
    });
    if (node.getTest() != nullptr && known_.varies(*node.getTest())) make_divergent(node);
  }

  void branch(const TIntermBranch& node) {
    switch (node.getFlowOp()) {
      case EOpBreak:
        if (!loops_.empty() && loops_.back().loop != nullptr && region_ != loops_.back().outside)
          make_divergent(*loops_.back().loop);
        return;
      case EOpContinue:
        for (auto frame = loops_.rbegin(); frame != loops_.rend(); ++frame) {
          if (frame->loop == nullptr) continue;
          if (region_ != frame->outside) insert(known_.divergent_bodies_, frame->loop);
          break;
        }
        return;
      case EOpKill:
        insert(known_.discarding_, function_);
        make_loops_divergent();
        return;
      case EOpReturn:
        break;
      default:
        return;
    }
    if (region_ != 0) {
      insert(known_.divergent_returns_, function_);
      make_loops_divergent();
    }
    if (node.getExpression() == nullptr) return;
    expression(*node.getExpression());
    const TType& type = node.getExpression()->getType();
    if (region_ != 0 || known_.diverges_at_return(*function_) || known_.varies(*node.getExpression()) ||
        type.isStruct() || type.isArray())
      insert(known_.varying_results_, function_);
  }

  void make_loops_divergent() {
    for (const LoopFrame& frame : loops_) {
      if (frame.loop != nullptr) make_divergent(*frame.loop);
    }
  }

  // `target` gets a value that varies or not.
  void assign(const TIntermNode& node, const TIntermTyped& target, bool value_varies) {
    const TIntermSymbol* symbol = base_symbol(target);
    if (symbol == nullptr) return;
    const SymbolId id = symbol->getId();
    const auto declared = declared_.find(id);
    const bool is_own = declared != declared_.end() && out_parameters_.count(id) == 0;
    const bool masked = !is_own || !contains(region_, declared->second);
    if (masked) known_.masked_.insert(&node);
    if (masked || value_varies || index_varies(target)) make_varying(*symbol);
  }

  // Whether some index in an l-value varies.
  bool index_varies(const TIntermTyped& target) const {
    const TIntermBinary* binary = target.getAsBinaryNode();
    if (binary == nullptr) return false;
    return (binary->getOp() == EOpIndexIndirect && known_.varies(*binary->getRight())) ||
           index_varies(*binary->getLeft());
  }

  void expression(const TIntermTyped& node) {
    if (const TIntermBinary* binary = node.getAsBinaryNode()) {
      expression(*binary->getLeft());
      const TOperator op = binary->getOp();
      const bool short_circuit = op == EOpLogicalAnd || op == EOpLogicalOr;
      const bool diverges = short_circuit && known_.varies(*binary->getLeft());
      if (diverges) make_divergent(node);
      within(diverges ? new_region() : region_, [&] { expression(*binary->getRight()); });
      if (const BinaryOperator assigned = assignment_operator(op); assigned.sign != nullptr)
        assign(node, *binary->getLeft(),
               known_.varies(*binary->getRight()) || binary->getLeft()->getType().isStruct());
    } else if (const TIntermUnary* unary = node.getAsUnaryNode()) {
      expression(*unary->getOperand());
      if (is_increment(unary->getOp())) assign(node, *unary->getOperand(), false);
    } else if (const TIntermSelection* choice = node.getAsSelectionNode()) {
      selection(*choice);
    } else if (const TIntermAggregate* aggregate = node.getAsAggregate()) {
      for (const TIntermNode* part : aggregate->getSequence()) expression(*part->getAsTyped());
      if (aggregate->getOp() == EOpFunctionCall) call(*aggregate);
      if (aggregate->getOp() == EOpModf)
        assign(node, *aggregate->getSequence()[1]->getAsTyped(),
               known_.varies(*aggregate->getSequence()[0]->getAsTyped()));
    }
  }

  void call(const TIntermAggregate& node) {
    const Function& callee = program_.function(node);
    if (known_.discards(callee)) {
      insert(known_.discarding_, function_);
      make_loops_divergent();
    }
    for (std::size_t i = 0; i < node.getSequence().size(); ++i) {
      const TIntermTyped& argument = *node.getSequence()[i]->getAsTyped();
      if (callee.parameters[i].is_out)
        assign(node, argument, true);
      else if (known_.varies(argument))
        make_varying(*callee.parameters[i].symbol);
    }
  }

  Uniformity& known_;
  const Program& program_;
  const std::map<const Function*, std::unique_ptr<Placement>>& placements_;
  bool changed_ = false;

  const Function* function_ = nullptr;
  const Placement* placement_ = nullptr;
  std::vector<int> parents_;  // of each region; region 0 is the function's body
  int region_ = 0;
  std::vector<LoopFrame> loops_;
  std::map<SymbolId, int> declared_;
  std::set<SymbolId> out_parameters_;
};

Uniformity::Uniformity(const Program& program) : program_(program) {
  std::map<const Function*, std::unique_ptr<Placement>> placements;
  for (const Function& function : program.functions())
    placements[&function] = std::make_unique<Placement>(program, function);
  while (UniformityPass(*this, placements).run()) {
  }
}

bool Uniformity::varies(const TIntermSymbol& symbol) const {
  const TStorageQualifier storage = symbol.getQualifier().storage;
  if (storage == EvqUniform) return symbol.getType().isStruct();  // structures are made of packets
  if (program_.is_global(symbol.getId())) return true;
  if (storage != EvqTemporary && storage != EvqIn && storage != EvqConst && storage != EvqConstReadOnly)
    return true;  // built-in variables, outputs, out parameters
  if (symbol.getType().isStruct() || symbol.getType().isArray()) return true;
  return varying_symbols_.count(symbol.getId()) != 0;
}

bool Uniformity::varies(const TIntermTyped& node) const {
  if (const TIntermSymbol* symbol = node.getAsSymbolNode()) return varies(*symbol);
  if (node.getAsConstantUnion() != nullptr) return is_wide_constant(node.getType());
  if (const TIntermBinary* binary = node.getAsBinaryNode()) {
    if (assignment_operator(binary->getOp()).sign != nullptr) return varies(*binary->getLeft());
    if (binary->getOp() == EOpVectorSwizzle || binary->getOp() == EOpIndexDirect ||
        binary->getOp() == EOpIndexDirectStruct)
      return varies(*binary->getLeft());
    return varies(*binary->getLeft()) || varies(*binary->getRight());
  }
  if (const TIntermUnary* unary = node.getAsUnaryNode())
    return is_derivative(unary->getOp()) || varies(*unary->getOperand());
  if (const TIntermSelection* choice = node.getAsSelectionNode()) {
    if (node.getType().isStruct() || node.getType().isArray()) return true;
    return varies(*choice->getCondition()) || varies(*choice->getTrueBlock()->getAsTyped()) ||
           varies(*choice->getFalseBlock()->getAsTyped());
  }
  const TIntermAggregate* aggregate = node.getAsAggregate();
  if (aggregate == nullptr) return true;
  const TIntermSequence& parts = aggregate->getSequence();
  if (aggregate->getOp() == EOpFunctionCall) return varies(program_.function(*aggregate));
  if (aggregate->getOp() == EOpComma || aggregate->getOp() == EOpSequence)
    return varies(*parts.back()->getAsTyped());
  if (has_implicit_lod(aggregate->getOp()) || is_derivative(aggregate->getOp())) return true;
  if (is_constructor(aggregate->getOp()) && (node.getType().isStruct() || node.getType().isArray()))
    return true;
  if (aggregate->getOp() == EOpModf) return varies(*parts[0]->getAsTyped());
  for (const TIntermNode* part : parts) {
    if (varies(*part->getAsTyped())) return true;
  }
  return false;
}

bool Uniformity::may_jump(const TIntermNode& statement) const {
  JumpFinder finder(program_, *this);
  const_cast<TIntermNode&>(statement).traverse(&finder);
  return finder.found;
}

}  // namespace shadertwin::emit
