#include <algorithm>
#include <map>
#include <set>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;

// What a condition ends in behind commas; null if there is none.
const TIntermTyped* last_operand(const TIntermTyped* condition) {
  while (condition != nullptr) {
    const TIntermAggregate* comma = condition->getAsAggregate();
    if (comma == nullptr || comma->getOp() != EOpComma) break;
    condition = comma->getSequence().back()->getAsTyped();
  }
  return condition;
}

// Whether a loop's condition never ends it: there is none, or its value is the constant true.
bool always_goes_on(const TIntermLoop& loop) {
  if (loop.getTest() == nullptr) return true;
  const TIntermConstantUnion* constant = last_operand(loop.getTest())->getAsConstantUnion();
  return constant != nullptr && constant->getConstArray()[0].getBConst();
}

// Finds what can end the loop whose body it walks.
class ExitFinder : public TIntermTraverser {
 public:
  explicit ExitFinder(bool discard_ends) : discard_ends_(discard_ends) {}

  bool found = false;

  bool visitLoop(TVisit, TIntermLoop* loop) override { return nested(loop->getBody()); }
  bool visitSwitch(TVisit, TIntermSwitch* choice) override { return nested(choice->getBody()); }
  bool visitBranch(TVisit, TIntermBranch* jump) override {
    const TOperator op = jump->getFlowOp();
    found |= op == EOpReturn || (op == EOpBreak && depth_ == 0) || (op == EOpKill && discard_ends_);
    return true;
  }

 private:
  // A `break` in there ends only what is nested.
  bool nested(TIntermNode* body) {
    ++depth_;
    if (body != nullptr) body->traverse(this);
    --depth_;
    return false;
  }

  bool discard_ends_;
  int depth_ = 0;
};

// Whether a value is one that leaves a variable as it is when it is added, multiplied ... to it.
bool has_no_effect(TOperator op, const TIntermTyped& value) {
  const TIntermConstantUnion* constant = value.getAsConstantUnion();
  if (constant == nullptr) return false;
  double wanted = 0.0;
  switch (op) {
    case EOpAddAssign:
    case EOpSubAssign:
    case EOpInclusiveOrAssign:
    case EOpExclusiveOrAssign:
    case EOpLeftShiftAssign:
    case EOpRightShiftAssign:
      break;
    case EOpMulAssign:
    case EOpVectorTimesScalarAssign:
    case EOpDivAssign:
      wanted = 1.0;
      break;
    default:
      return false;
  }
  const TConstUnionArray& values = constant->getConstArray();
  for (int i = 0; i < values.size(); ++i) {
    if (number_of(values[i]) != wanted) return false;
  }
  return true;
}

// The variables that a round of a loop changes.
class ChangeFinder : public TIntermTraverser {
 public:
  explicit ChangeFinder(const emit::Program& program) : program_(program) {}

  std::set<emit::SymbolId> changed;

  bool visitBinary(TVisit, TIntermBinary* node) override {
    if (node->modifiesState() && !has_no_effect(node->getOp(), *node->getRight()) && !is_itself(*node))
      add(*node->getLeft());
    return true;
  }
  bool visitUnary(TVisit, TIntermUnary* node) override {
    if (node->modifiesState()) add(*node->getOperand());
    return true;
  }
  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    // What a call changes; of other nodes the parts are asked.
    if (node->getOp() == EOpFunctionCall || node->modifiesState()) {
      const auto& writes = program_.effects(*node).writes;
      changed.insert(writes.begin(), writes.end());
    }
    return true;
  }

 private:
  void add(const TIntermTyped& lvalue) {
    if (const TIntermSymbol* symbol = emit::base_symbol(lvalue)) changed.insert(symbol->getId());
  }
  // `x = x`
  static bool is_itself(const TIntermBinary& node) {
    const TIntermSymbol* left = node.getLeft()->getAsSymbolNode();
    const TIntermSymbol* right = node.getRight()->getAsSymbolNode();
    return node.getOp() == EOpAssign && left != nullptr && right != nullptr &&
           left->getId() == right->getId();
  }

  const emit::Program& program_;
};

// Whether no round of the loop changes anything that its condition reads.
bool stands_still(const emit::Program& program, const TIntermLoop& loop) {
  if (loop.getTest() == nullptr || last_operand(loop.getTest())->getAsConstantUnion() != nullptr)
    return false;
  ChangeFinder finder(program);
  for (TIntermNode* part : {loop.getBody(), static_cast<TIntermNode*>(loop.getTerminal()),
                            static_cast<TIntermNode*>(const_cast<TIntermTyped*>(loop.getTest()))})
    if (part != nullptr) part->traverse(&finder);
  // A call may discard.
  if (finder.changed.count(emit::Program::control_flow) != 0) return false;
  const auto& reads = program.effects(*last_operand(loop.getTest())).reads;
  return std::none_of(reads.begin(), reads.end(),
                      [&](emit::SymbolId id) { return finder.changed.count(id) != 0; });
}

// Counts what writes each variable of a shader, and finds those whose declaration says `= true` or `= false`.
class Flags : public TIntermTraverser {
 public:
  explicit Flags(const emit::Program& program) : program_(program) {
    const_cast<TIntermAggregate&>(program.tree().root()).traverse(this);  // it has no const traversal
  }

  // Whether nothing but its declaration, which makes it that, writes it.
  bool stays(emit::SymbolId id, bool value) const {
    const auto flag = flags_.find(id);
    const auto found = writes_.find(id);
    return flag != flags_.end() && flag->second == value && found != writes_.end() && found->second == 1;
  }

  bool visitBinary(TVisit, TIntermBinary* node) override {
    if (!node->modifiesState()) return true;
    const TIntermSymbol* symbol = emit::base_symbol(*node->getLeft());
    if (symbol == nullptr) return true;
    ++writes_[symbol->getId()];
    const TIntermConstantUnion* value = node->getRight()->getAsConstantUnion();
    const bool is_flag = symbol->getBasicType() == EbtBool && symbol->getType().isScalar();
    if (is_flag && value != nullptr && is_declared_by(*symbol))
      flags_[symbol->getId()] = value->getConstArray()[0].getBConst();
    return true;
  }
  bool visitUnary(TVisit, TIntermUnary* node) override {
    if (const TIntermSymbol* symbol = emit::base_symbol(*node->getOperand());
        node->modifiesState() && symbol != nullptr)
      ++writes_[symbol->getId()];
    return true;
  }
  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    const TQualifierList& how = node->getQualifierList();
    for (std::size_t i = 0; i < how.size() && i < node->getSequence().size(); ++i) {
      const TIntermTyped* argument = node->getSequence()[i]->getAsTyped();
      if (argument == nullptr || !emit::is_out(how[i])) continue;
      if (const TIntermSymbol* symbol = emit::base_symbol(*argument)) ++writes_[symbol->getId()];
    }
    return true;
  }

 private:
  bool is_declared_by(const TIntermSymbol& symbol) const {
    const int token = program_.tree().token_of(symbol);
    const auto& variables = program_.tree().declarations().variables();
    return std::any_of(variables.begin(), variables.end(), [&](const Variable& variable) {
      return variable.name == token && variable.initialised;
    });
  }

  const emit::Program& program_;
  std::map<emit::SymbolId, int> writes_;
  std::map<emit::SymbolId, bool> flags_;
};

class LoopCollector : public TIntermTraverser {
 public:
  explicit LoopCollector(const emit::Program& program) : program_(program), flags_(program) {}

  std::vector<const TIntermLoop*> refused;   // by browsers
  std::vector<const TIntermLoop*> endless;   // that browsers take
  std::vector<const TIntermLoop*> standing;  // their condition does not change

  // ANGLE refuses `for` and `while` without an end, also those that only `discard` ends, and takes `do`. Of
  // conditions it knows `true` and variables that are true in the whole shader, also behind commas if nothing
  // in front of them has an effect.
  bool visitLoop(TVisit, TIntermLoop* loop) override {
    const TIntermTyped* value = last_operand(loop->getTest());
    const TIntermSymbol* variable = value == nullptr ? nullptr : value->getAsSymbolNode();
    const auto stays = [&](bool flag) {
      return variable != nullptr && flags_.stays(variable->getId(), flag);
    };
    const bool goes_on = always_goes_on(*loop);
    const bool is_known = loop->testFirst() &&
                          (value == nullptr || program_.effects(*loop->getTest()).writes.empty()) &&
                          (goes_on || stays(true));
    ExitFinder exits(!is_known);
    if (loop->getBody() != nullptr) loop->getBody()->traverse(&exits);
    if (exits.found) return true;
    if (is_known)
      refused.push_back(loop);
    else if (goes_on)
      endless.push_back(loop);
    else if (!(loop->testFirst() && stays(false)) && stands_still(program_, *loop))
      standing.push_back(loop);
    return true;
  }

 private:
  const emit::Program& program_;
  Flags flags_;
};

}  // namespace

std::vector<Finding> endless_loops(const ParsedPass& parsed) {
  LoopCollector loops(parsed.program);
  const_cast<TIntermAggregate&>(parsed.tree.root()).traverse(&loops);  // it has no const traversal
  std::vector<Finding> findings;
  const auto tell = [&](const std::vector<const TIntermLoop*>& found, const char* kind, const char* text) {
    for (const TIntermLoop* loop : found)
      findings.push_back(make_finding(parsed.project, parsed.pass, parsed.tree.line_of(*loop), kind, text));
  };
  tell(loops.refused, "webgl2", "no break or return leaves this loop: browsers refuse it");
  tell(loops.endless, "loop", "nothing leaves this loop");
  tell(loops.standing, "loop", "no round of this loop changes its condition: it never ends");
  return findings;
}

}  // namespace shadertwin::check
