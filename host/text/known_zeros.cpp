#include "host/text/known_zeros.h"

#include <algorithm>

namespace shadertwin {

using glslang::TIntermAggregate;
using glslang::TIntermTyped;

// Notes what every variable, parameter and function may get its value from.
class KnownZeros::Collector : public glslang::TIntermTraverser {
 public:
  explicit Collector(KnownZeros& zeros) : zeros_(zeros) {}

  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    if (node->modifiesState()) assign(*node->getLeft(), node->getRight());
    return true;
  }

  bool visitAggregate(glslang::TVisit, TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpFunction) {
      function_ = node->getName().c_str();
      if (const auto* parameters = node->getSequence()[0]->getAsAggregate())
        for (const TIntermNode* parameter : parameters->getSequence())
          if (const auto* symbol = parameter->getAsSymbolNode())
            parameters_[function_].push_back(symbol->getId());
    }
    if (node->getOp() == glslang::EOpFunctionCall) calls_.push_back(node);
    for (std::size_t i = 0; i < node->getQualifierList().size() && i < node->getSequence().size(); ++i)
      if (const glslang::TStorageQualifier storage = node->getQualifierList()[i];
          storage == glslang::EvqOut || storage == glslang::EvqInOut)
        assign(*node->getSequence()[i]->getAsTyped(), nullptr);
    return true;
  }

  bool visitBranch(glslang::TVisit, glslang::TIntermBranch* node) override {
    if (node->getFlowOp() == glslang::EOpReturn && node->getExpression() != nullptr)
      zeros_.returned_[function_].push_back(node->getExpression());
    return true;
  }

  void match_calls() {
    for (const TIntermAggregate* call : calls_) {
      const auto found = parameters_.find(call->getName().c_str());
      if (found == parameters_.end()) continue;
      for (std::size_t i = 0; i < std::min(found->second.size(), call->getSequence().size()); ++i)
        if (const TIntermTyped* argument = call->getSequence()[i]->getAsTyped())
          zeros_.passed_[found->second[i]].push_back(argument);
    }
  }

 private:
  using TIntermNode = ::TIntermNode;

  void assign(const TIntermTyped& place, const TIntermTyped* value) {
    const TIntermTyped* base = &place;
    while (const auto* part = base->getAsBinaryNode()) base = part->getLeft();
    if (const auto* symbol = base->getAsSymbolNode()) zeros_.assigned_[symbol->getId()].push_back(value);
  }

  KnownZeros& zeros_;
  std::string function_;
  std::map<std::string, std::vector<long long>> parameters_;
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

bool KnownZeros::of_variable(Question question, long long id) {
  // What a variable gets from itself changes neither answer.
  const auto [answer, is_new] = answers_.try_emplace({id, question}, question == Question::known);
  if (!is_new) return answer->second;
  const bool known = all_known(assigned_[id]);
  const bool result = question == Question::known
                          ? known
                          : (known && any(question, assigned_[id])) || any(question, passed_[id]);
  return answers_[{id, question}] = result;
}

bool KnownZeros::of_call(Question question, const TIntermAggregate& call) {
  const std::pair<std::string, Question> asked{call.getName().c_str(), question};
  if (!asked_.insert(asked).second) return false;
  const Values& values = returned_[asked.first];
  const bool result = all_known(values) && (question == Question::known || any(question, values));
  asked_.erase(asked);
  return result;
}

bool KnownZeros::holds(Question question, const TIntermTyped& node) {
  if (const auto* constant = node.getAsConstantUnion()) {
    if (question == Question::known) return true;
    for (int i = 0; i < constant->getConstArray().size(); ++i) {
      const glslang::TConstUnion& value = constant->getConstArray()[i];
      if (value.getType() == glslang::EbtDouble ? value.getDConst() == 0 : value.getUConst() == 0)
        return true;
    }
    return false;
  }
  if (const auto* symbol = node.getAsSymbolNode()) return of_variable(question, symbol->getId());
  if (const auto* choice = const_cast<TIntermTyped&>(node).getAsSelectionNode()) {
    const auto* yes = choice->getTrueBlock() != nullptr ? choice->getTrueBlock()->getAsTyped() : nullptr;
    const auto* no = choice->getFalseBlock() != nullptr ? choice->getFalseBlock()->getAsTyped() : nullptr;
    return yes != nullptr && no != nullptr && holds(Question::known, *choice->getCondition()) &&
           (holds(question, *yes) || holds(question, *no));
  }
  if (const auto* unary = node.getAsUnaryNode()) {
    const glslang::TOperator op = unary->getOp();
    const bool keeps_zero = op == glslang::EOpNegative || op == glslang::EOpAbs ||
                            op == glslang::EOpConvIntToFloat || op == glslang::EOpConvUintToFloat ||
                            op == glslang::EOpSqrt;
    return holds(keeps_zero ? question : Question::known, *unary->getOperand());
  }
  if (const auto* binary = node.getAsBinaryNode()) {
    const TIntermTyped& left = *binary->getLeft();
    const TIntermTyped& right = *binary->getRight();
    switch (binary->getOp()) {
      case glslang::EOpIndexDirect:
      case glslang::EOpIndexIndirect:
      case glslang::EOpIndexDirectStruct:
      case glslang::EOpVectorSwizzle:
      case glslang::EOpDiv:
        return holds(question, left) &&
               (binary->getOp() != glslang::EOpDiv || question == Question::zero || holds(question, right));
      case glslang::EOpMul:
      case glslang::EOpVectorTimesScalar:
        return question == Question::zero ? holds(question, left) || holds(question, right)
                                          : holds(question, left) && holds(question, right);
      case glslang::EOpAssign:
        return holds(question, right);
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
