#include <algorithm>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;

// Whether a loop's condition never ends it: there is none, or it is the constant true.
bool always_goes_on(const TIntermLoop& loop) {
  if (loop.getTest() == nullptr) return true;
  const TIntermConstantUnion* constant = loop.getTest()->getAsConstantUnion();
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

// ANGLE refuses `for` and `while` without an end, also those that only `discard` ends, and takes `do`.
bool browsers_refuse(const TIntermLoop& loop) {
  return loop.testFirst();
}

class LoopCollector : public TIntermTraverser {
 public:
  std::vector<const TIntermLoop*> endless;

  bool visitLoop(TVisit, TIntermLoop* loop) override {
    ExitFinder exits(!browsers_refuse(*loop));
    if (loop->getBody() != nullptr) loop->getBody()->traverse(&exits);
    if (always_goes_on(*loop) && !exits.found) endless.push_back(loop);
    return true;
  }
};

}  // namespace

std::vector<Finding> endless_loops(const ParsedPass& parsed) {
  LoopCollector loops;
  const_cast<TIntermAggregate&>(parsed.tree.root()).traverse(&loops);  // it has no const traversal
  std::vector<Finding> findings;
  for (const TIntermLoop* loop : loops.endless) {
    const SourceLine at = parsed.tree.line_of(*loop);
    findings.push_back(
        browsers_refuse(*loop)
            ? make_finding(parsed.project, parsed.pass, at, "webgl2",
                           "no break or return leaves this loop: browsers refuse it")
            : make_finding(parsed.project, parsed.pass, at, "loop", "nothing leaves this loop"));
  }
  return findings;
}

}  // namespace shadertwin::check
