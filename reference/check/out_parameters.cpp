#include <algorithm>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;

// Follows one `out` parameter through its function.
class OutParameter {
 public:
  OutParameter(const emit::Program& program, emit::SymbolId id) : program_(program), id_(id) {}

  // The returns that are reached without a write; null stands for the function's end.
  std::vector<const TIntermNode*> unwritten_returns(const TIntermNode* body) {
    const Paths end = follow(body, {true, false});
    if (end.unwritten) returns_.push_back(nullptr);
    return returns_;
  }

 private:
  // Which paths reach a place.
  struct Paths {
    bool unwritten = false;
    bool written = false;

    Paths operator|(const Paths& other) const {
      return {unwritten || other.unwritten, written || other.written};
    }
    bool any() const { return unwritten || written; }
  };

  Paths touched(const TIntermNode& node, Paths paths) const {
    if (paths.any() && program_.effects(node).writes.count(id_) != 0) return {false, true};
    return paths;
  }

  Paths follow(const TIntermNode* node, Paths paths) {
    if (node == nullptr || !paths.any()) return paths;
    if (const TIntermAggregate* sequence = node->getAsAggregate();
        sequence != nullptr && sequence->getOp() == EOpSequence) {
      for (const TIntermNode* part : sequence->getSequence()) paths = follow(part, paths);
      return paths;
    }
    if (const TIntermSelection* choice = node->getAsSelectionNode();
        choice != nullptr && choice->getBasicType() == EbtVoid) {
      paths = touched(*choice->getCondition(), paths);
      return follow(choice->getTrueBlock(), paths) | follow(choice->getFalseBlock(), paths);
    }
    if (const TIntermLoop* loop = node->getAsLoopNode()) return follow_loop(*loop, paths);
    if (const TIntermSwitch* choice = node->getAsSwitchNode()) return follow_switch(*choice, paths);
    if (const TIntermBranch* jump = node->getAsBranchNode()) return follow_jump(*jump, paths);
    return touched(*node, paths);
  }

  // The body runs: who writes an array in a loop writes it.
  Paths follow_loop(const TIntermLoop& loop, Paths paths) {
    const Paths outer = std::exchange(breaks_, {});
    if (loop.getTest() != nullptr) paths = touched(*loop.getTest(), paths);
    Paths end = follow(loop.getBody(), paths);
    // What a round leaves through break was written if other rounds come before it and write.
    if (breaks_.unwritten && end.written && !end.unwritten) breaks_ = {false, true};
    const Paths left = end | breaks_;
    breaks_ = outer;
    return left;
  }

  Paths follow_switch(const TIntermSwitch& choice, Paths paths) {
    const Paths outer = std::exchange(breaks_, {});
    paths = touched(*choice.getCondition(), paths);
    const Paths start = paths;
    Paths now;
    bool has_default = false;
    for (const TIntermNode* part : choice.getBody()->getSequence()) {
      const TIntermBranch* label = part != nullptr ? part->getAsBranchNode() : nullptr;
      if (label != nullptr && (label->getFlowOp() == EOpCase || label->getFlowOp() == EOpDefault)) {
        has_default |= label->getFlowOp() == EOpDefault;
        now = now | start;
      } else {
        now = follow(part, now);
      }
    }
    const Paths left = now | breaks_ | (has_default ? Paths{} : start);
    breaks_ = outer;
    return left;
  }

  Paths follow_jump(const TIntermBranch& jump, Paths paths) {
    if (jump.getExpression() != nullptr) paths = touched(*jump.getExpression(), paths);
    if (jump.getFlowOp() == EOpReturn && paths.unwritten) returns_.push_back(&jump);
    if (jump.getFlowOp() == EOpBreak || jump.getFlowOp() == EOpContinue) breaks_ = breaks_ | paths;
    return {};
  }

  const emit::Program& program_;
  emit::SymbolId id_;
  Paths breaks_;
  std::vector<const TIntermNode*> returns_;
};

}  // namespace

std::vector<Finding> unwritten_outputs(const ParsedPass& parsed) {
  std::vector<Finding> findings;
  for (const emit::Function& function : parsed.program.functions()) {
    for (const emit::Parameter& parameter : function.parameters) {
      if (!parameter.is_out || parameter.is_inout) continue;
      OutParameter path(parsed.program, parameter.symbol->getId());
      for (const TIntermNode* end : path.unwritten_returns(function.body)) {
        const SourceLine at = parsed.tree.line_of(end != nullptr ? *end : *function.definition);
        if (at.file < 0) continue;
        findings.push_back(
            make_finding(parsed.project, parsed.pass, at, "out",
                         "'" + std::string(parameter.symbol->getName().c_str()) + "' of " + function.name +
                             (end != nullptr ? "() is not written on a path to this return"
                                             : "() is not written on a path to the function's end")));
      }
    }
  }
  return findings;
}

}  // namespace shadertwin::check
