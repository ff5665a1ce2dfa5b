#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;

// Operators that ANGLE does not take although the language leaves them open.
class OperatorFinder : public TIntermTraverser {
 public:
  explicit OperatorFinder(const SyntaxTree& tree) : tree_(tree) {}

  std::vector<std::pair<const TIntermNode*, std::string>> found;

  bool visitSelection(TVisit, TIntermSelection* choice) override {
    const TType& type = choice->getType();
    if (choice->getBasicType() != EbtVoid && (type.isArray() || type.isStruct()))
      found.emplace_back(choice, "`?:` between arrays or structures: browsers refuse it");
    return true;
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    // The tree has f().length() as (f(), 3), too.
    if (node->getOp() != EOpComma || tree_.token_text(*node) != ",") return true;
    const bool wrong =
        std::any_of(node->getSequence().begin(), node->getSequence().end(), [](TIntermNode* part) {
          const TIntermTyped* typed = part->getAsTyped();
          return typed != nullptr && (typed->getBasicType() == EbtVoid || typed->getType().containsArray());
        });
    if (wrong) found.emplace_back(node, "a comma between arrays or void: browsers refuse it");
    return true;
  }

  bool visitSwitch(TVisit, TIntermSwitch* choice) override {
    const TBasicType wanted = choice->getCondition()->getAsTyped()->getBasicType();
    for (TIntermNode* part : choice->getBody()->getSequence()) {
      const TIntermBranch* label = part != nullptr ? part->getAsBranchNode() : nullptr;
      if (label != nullptr && label->getFlowOp() == EOpCase &&
          label->getExpression()->getBasicType() != wanted)
        found.emplace_back(label->getExpression(),
                           "a label of another type than its switch: browsers refuse it");
    }
    return true;
  }

 private:
  const SyntaxTree& tree_;
};

class Limits {
 public:
  explicit Limits(const ParsedPass& parsed) : parsed_(parsed), tree_(parsed.tree) {}

  std::vector<Finding> find() {
    large_variables();
    operators();
    if (!parsed_.pass.vertex.has_value()) unmatched_inputs();
    return std::move(findings_);
  }

 private:
  void add(int token, const std::string& text) {
    const SourceLine at = tree_.line_of_token(token);
    if (at.file >= 0) findings_.push_back(make_finding(parsed_.project, parsed_.pass, at, "webgl2", text));
  }

  void operators() {
    OperatorFinder finder(tree_);
    const_cast<TIntermAggregate&>(tree_.root()).traverse(&finder);  // it has no const traversal
    for (const auto& [node, text] : finder.found) add(tree_.token_of(*node), text);
  }

  void large_variables() {
    for (const LargeVariable& variable : parsed_.storage.large)
      add(variable.token, "'" + variable.name + "' has 64 KB or more: browsers refuse it");
    if (parsed_.storage.is_too_large_together())
      findings_.push_back(make_finding(parsed_.project, parsed_.pass, {}, "webgl2",
                                       "the variables have more than 16 MB together: browsers refuse it"));
  }

  // Neither host has a vertex shader with outputs.
  void unmatched_inputs() {
    const std::vector<UnsetInput>& unset = parsed_.pass.unset_inputs;
    std::set<int> inputs;
    for (const Variable& variable : tree_.declarations().variables())
      if (variable.place == Variable::Place::global &&
          std::ranges::find(unset, tree_.tokens()[static_cast<std::size_t>(variable.name)].text,
                            &UnsetInput::name) != unset.end())
        inputs.insert(variable.name);
    for (int token = 0; !inputs.empty() && token < static_cast<int>(tree_.tokens().size()); ++token) {
      const int declaration = tree_.declarations().declaration_of(token);
      if (declaration == token || inputs.erase(declaration) == 0) continue;
      add(declaration, "'" + tree_.tokens()[static_cast<std::size_t>(declaration)].text +
                           "' is an input that no vertex shader gives: browsers refuse it");
    }
  }

  const ParsedPass& parsed_;
  const SyntaxTree& tree_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> browser_limits(const ParsedPass& parsed) {
  return Limits(parsed).find();
}

}  // namespace shadertwin::check
