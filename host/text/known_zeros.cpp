#include "host/text/known_zeros.h"

#include <algorithm>
#include <limits>

namespace shadertwin {

using glslang::TIntermAggregate;
using glslang::TIntermTyped;

// Notes what every variable, parameter and function may get its value from, in the order of the text.
class KnownZeros::Collector : public glslang::TIntermTraverser {
 public:
  explicit Collector(KnownZeros& zeros) : TIntermTraverser(true, false, true), zeros_(zeros) {}

  void visitSymbol(glslang::TIntermSymbol* node) override { zeros_.uses_.emplace(node, ++time_); }

  bool visitBinary(glslang::TVisit visit, glslang::TIntermBinary* node) override {
    if (visit == glslang::EvPostVisit && node->modifiesState())
      assign(*node->getLeft(), node->getOp() == glslang::EOpAssign ? node->getRight() : node);
    return true;
  }

  bool visitUnary(glslang::TVisit visit, glslang::TIntermUnary* node) override {
    if (visit == glslang::EvPostVisit && node->modifiesState()) assign(*node->getOperand(), node);
    return true;
  }

  bool visitAggregate(glslang::TVisit visit, TIntermAggregate* node) override {
    if (visit == glslang::EvPreVisit && node->getOp() == glslang::EOpFunction) {
      function_ = node->getName().c_str();
      if (const auto* parameters = node->getSequence()[0]->getAsAggregate())
        for (const TIntermNode* parameter : parameters->getSequence())
          if (const auto* symbol = parameter->getAsSymbolNode()) {
            parameters_[function_].push_back(symbol);
            if (symbol->getQualifier().storage != glslang::EvqOut) zeros_.inputs_.insert(symbol->getId());
            zeros_.uses_[symbol] = std::numeric_limits<int>::max();  // what it is when the function ends
          }
    }
    if (visit == glslang::EvPostVisit && node->getOp() == glslang::EOpFunctionCall) call(*node);
    return true;
  }

  bool visitBranch(glslang::TVisit visit, glslang::TIntermBranch* node) override {
    if (visit == glslang::EvPreVisit && node->getFlowOp() == glslang::EOpReturn &&
        node->getExpression() != nullptr)
      zeros_.returned_[function_].push_back(node->getExpression());
    return true;
  }

  void match_calls() {
    for (const TIntermAggregate* call : calls_) {
      const auto found = parameters_.find(call->getName().c_str());
      if (found == parameters_.end()) continue;
      for (std::size_t i = 0; i < std::min(found->second.size(), call->getSequence().size()); ++i)
        if (const long long id = found->second[i]->getId(); zeros_.inputs_.contains(id))
          zeros_.passed_[id].push_back(call->getSequence()[i]->getAsTyped());
    }
  }

 private:
  using TIntermNode = ::TIntermNode;

  void call(const TIntermAggregate& node) {
    calls_.push_back(&node);
    const auto& storages = const_cast<TIntermAggregate&>(node).getQualifierList();
    const auto found = parameters_.find(node.getName().c_str());
    for (std::size_t i = 0; i < std::min(storages.size(), node.getSequence().size()); ++i) {
      if (storages[i] != glslang::EvqOut && storages[i] != glslang::EvqInOut) continue;
      const bool is_defined = found != parameters_.end() && i < found->second.size();
      assign(*node.getSequence()[i]->getAsTyped(), is_defined ? found->second[i] : nullptr);
    }
  }

  void assign(const TIntermTyped& place, const TIntermTyped* value) {
    const TIntermTyped* base = &place;
    while (const auto* part = base->getAsBinaryNode()) base = part->getLeft();
    if (const auto* symbol = base->getAsSymbolNode())
      zeros_.assigned_[symbol->getId()].push_back({value, ++time_, base == &place});
  }

  KnownZeros& zeros_;
  int time_ = 0;
  std::string function_;
  std::map<std::string, std::vector<const glslang::TIntermSymbol*>> parameters_;
  std::vector<const TIntermAggregate*> calls_;
};

KnownZeros::KnownZeros(const SyntaxTree& tree) {
  Collector collector(*this);
  const_cast<TIntermAggregate&>(tree.root()).traverse(&collector);
  collector.match_calls();
}

bool KnownZeros::may_be_zero(const TIntermTyped& node) {
  return holds(Question::zero, node);
}

bool KnownZeros::any(Question question, const Values& values) {
  return std::any_of(values.begin(), values.end(),
                     [&](const TIntermTyped* v) { return v != nullptr && holds(question, *v); });
}

bool KnownZeros::all_known(const Values& values) {
  return !values.empty() && std::all_of(values.begin(), values.end(), [&](const TIntermTyped* v) {
    return v != nullptr && holds(Question::known, *v);
  });
}

bool KnownZeros::of_variable(Question question, const glslang::TIntermSymbol& symbol) {
  const long long id = symbol.getId();
  // What a variable gets from itself changes neither answer.
  const auto [answer, is_new] = answers_.try_emplace({id, question}, question == Question::known);
  if (is_new) {
    const std::vector<Assignment>& assignments = assigned_[id];
    const auto gives = [&](Question asked) {
      return [this, asked](const Assignment& assignment) { return is_given(asked, assignment); };
    };
    const bool known = !inputs_.contains(id) && !assignments.empty() &&
                       std::all_of(assignments.begin(), assignments.end(), gives(Question::known));
    answer->second = known && (question == Question::known ||
                               std::any_of(assignments.begin(), assignments.end(), gives(Question::zero)));
  }
  return answer->second || (question == Question::zero && was_zero(symbol));
}

bool KnownZeros::was_zero(const glslang::TIntermSymbol& symbol) {
  std::vector<Assignment>& assignments = assigned_[symbol.getId()];
  const auto use = uses_.find(&symbol);
  if (use == uses_.end()) return false;
  for (auto last = assignments.rbegin(); last != assignments.rend(); ++last) {
    if (last->time > use->second) continue;
    if (!last->is_zero) {
      last->is_zero = false;
      last->is_zero = is_given(Question::zero, *last);
    }
    if (*last->is_zero || last->is_whole) return *last->is_zero;
  }
  const glslang::TStorageQualifier storage = symbol.getQualifier().storage;
  if (inputs_.contains(symbol.getId())) {
    const auto [answer, is_new] = passed_zero_.try_emplace(symbol.getId(), false);
    if (is_new) answer->second = any(Question::zero, passed_[symbol.getId()]);
    return answer->second;
  }
  return storage == glslang::EvqTemporary || storage == glslang::EvqGlobal || storage == glslang::EvqOut;
}

bool KnownZeros::is_given(Question question, const Assignment& assignment) {
  if (assignment.value == nullptr) return false;
  const auto* step = assignment.value->getAsUnaryNode();
  if (step == nullptr || !step->modifiesState()) return holds(question, *assignment.value);
  if (question == Question::zero && stays_positive(*step->getOperand())) return false;
  return holds(Question::known, *step->getOperand());
}

bool KnownZeros::of_call(Question question, const TIntermAggregate& call) {
  const std::pair<std::string, Question> asked{call.getName().c_str(), question};
  if (!asked_.insert(asked).second) return false;
  const Values& values = returned_[asked.first];
  const bool result = all_known(values) && (question == Question::known || any(question, values));
  asked_.erase(asked);
  return result;
}

// Whether a variable is positive once it is assigned, and only grows from there.
bool KnownZeros::stays_positive(const TIntermTyped& place) {
  const auto* symbol = place.getAsSymbolNode();
  if (symbol == nullptr || !passed_[symbol->getId()].empty()) return false;
  const std::vector<Assignment>& assignments = assigned_[symbol->getId()];
  return std::all_of(assignments.begin(), assignments.end(), [](const Assignment& assignment) {
    if (assignment.value == nullptr) return false;
    if (const auto* unary = assignment.value->getAsUnaryNode())
      return unary->getOp() == glslang::EOpPostIncrement || unary->getOp() == glslang::EOpPreIncrement;
    const auto* compound = assignment.value->getAsBinaryNode();
    const bool grows = compound != nullptr && (compound->getOp() == glslang::EOpAddAssign ||
                                               compound->getOp() == glslang::EOpMulAssign);
    return is_constant_that(grows ? *compound->getRight() : *assignment.value,
                            [](double x) { return x > 0; });
  });
}

bool KnownZeros::holds(Question question, const TIntermTyped& node) {
  if (node.getAsConstantUnion() != nullptr) {
    return question == Question::known || !is_constant_that(node, [](double x) { return x != 0; });
  }
  if (const auto* symbol = node.getAsSymbolNode()) return of_variable(question, *symbol);
  if (const auto* choice = const_cast<TIntermTyped&>(node).getAsSelectionNode()) {
    const auto* yes = choice->getTrueBlock() != nullptr ? choice->getTrueBlock()->getAsTyped() : nullptr;
    const auto* no = choice->getFalseBlock() != nullptr ? choice->getFalseBlock()->getAsTyped() : nullptr;
    if (yes == nullptr || no == nullptr) return false;
    const bool first = holds(question, *yes);
    const bool second = holds(question, *no);
    return (first && second) || ((first || second) && holds(Question::known, *choice->getCondition()));
  }
  if (const auto* unary = node.getAsUnaryNode()) {
    const glslang::TOperator op = unary->getOp();
    if (op == glslang::EOpPreIncrement && question == Question::zero && stays_positive(*unary->getOperand()))
      return false;
    const bool keeps_zero = op == glslang::EOpPostIncrement || op == glslang::EOpPostDecrement ||
                            op == glslang::EOpNegative || op == glslang::EOpAbs ||
                            op == glslang::EOpConvIntToFloat || op == glslang::EOpConvUintToFloat ||
                            op == glslang::EOpSqrt;
    return holds(keeps_zero ? question : Question::known, *unary->getOperand());
  }
  if (const auto* binary = node.getAsBinaryNode()) {
    const TIntermTyped& left = *binary->getLeft();
    const TIntermTyped& right = *binary->getRight();
    switch (binary->getOp()) {
      case glslang::EOpIndexIndirect:
        return holds(question, left) && holds(Question::known, right);
      case glslang::EOpIndexDirect:
      case glslang::EOpIndexDirectStruct:
      case glslang::EOpVectorSwizzle:
        return holds(question, left);
      case glslang::EOpDiv:
      case glslang::EOpDivAssign:
        return holds(question, left) && (question == Question::zero || holds(question, right));
      case glslang::EOpMul:
      case glslang::EOpVectorTimesScalar:
      case glslang::EOpMatrixTimesScalar:
      case glslang::EOpMulAssign:
      case glslang::EOpVectorTimesScalarAssign:
      case glslang::EOpMatrixTimesScalarAssign:
        return question == Question::zero ? holds(question, left) || holds(question, right)
                                          : holds(question, left) && holds(question, right);
      case glslang::EOpAssign:
        return holds(question, right);
      case glslang::EOpAddAssign:
        if (question == Question::zero && stays_positive(left)) return false;
        [[fallthrough]];
      default:
        return holds(Question::known, left) && holds(Question::known, right);
    }
  }
  const auto* aggregate = node.getAsAggregate();
  if (aggregate == nullptr) return false;
  if (aggregate->getOp() == glslang::EOpFunctionCall) return of_call(question, *aggregate);
  Values parts;
  for (auto* part : aggregate->getSequence()) parts.push_back(part->getAsTyped());
  const bool constructs = aggregate->getOp() > glslang::EOpConstructGuardStart &&
                          aggregate->getOp() < glslang::EOpConstructGuardEnd;
  return constructs ? any(question, parts) : all_known(parts);
}

}  // namespace shadertwin
