#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;

// ANGLE refuses a variable of 64 KiB, every component counted as four bytes (Chromium's WebGL2, found by
// halving: float[16383] and vec3[5461] pass, float[16384] and vec3[5462] don't).
constexpr int most_components = 16383;

bool is_variable(TStorageQualifier qualifier) {
  switch (qualifier) {
    case EvqTemporary:
    case EvqGlobal:
    case EvqConst:
    case EvqConstReadOnly:
    case EvqIn:
    case EvqOut:
    case EvqInOut:
      return true;
    default:
      return false;
  }
}

// Each variable that is used, and each global one, once.
class SymbolCollector : public TIntermTraverser {
 public:
  std::map<long long, const TIntermSymbol*> symbols;

  void visitSymbol(TIntermSymbol* symbol) override { symbols.emplace(symbol->getId(), symbol); }
};

// Operators that ANGLE does not take although the language leaves them open.
class OperatorFinder : public TIntermTraverser {
 public:
  std::vector<std::pair<const TIntermNode*, std::string>> found;

  bool visitSelection(TVisit, TIntermSelection* choice) override {
    const TType& type = choice->getType();
    if (choice->getBasicType() != EbtVoid && (type.isArray() || type.isStruct()))
      found.emplace_back(choice, "`?:` between arrays or structures: browsers refuse it");
    return true;
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() != EOpComma) return true;
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
    OperatorFinder finder;
    const_cast<TIntermAggregate&>(tree_.root()).traverse(&finder);  // it has no const traversal
    for (const auto& [node, text] : finder.found) add(tree_.token_of(*node), text);
  }

  void large_variables() {
    SymbolCollector collector;
    const_cast<TIntermAggregate&>(tree_.root()).traverse(&collector);  // it has no const traversal
    for (const auto& [id, symbol] : collector.symbols) {
      if (!is_variable(symbol->getQualifier().storage)) continue;
      if (symbol->getType().computeNumComponents() <= most_components) continue;
      const std::string name = symbol->getName().c_str();
      add(declaration_of(*symbol, name), "'" + name + "' has 64 KB or more: browsers refuse it");
    }
  }

  // A global variable that nothing uses stands for no token, a parameter for one beside its name.
  int declaration_of(const TIntermSymbol& symbol, const std::string& name) const {
    const Declarations& declarations = tree_.declarations();
    if (const int declaration = declarations.declaration_of(tree_.token_of(symbol)); declaration >= 0)
      return declaration;
    for (const Variable& variable : declarations.variables())
      if (variable.place == Variable::Place::global && variable.name >= 0 &&
          tree_.tokens()[static_cast<std::size_t>(variable.name)].text == name)
        return variable.name;
    return tree_.token_of(symbol);
  }

  // Neither host has a vertex shader with outputs.
  void unmatched_inputs() {
    std::set<int> inputs;
    for (const Variable& variable : tree_.declarations().variables())
      if (variable.place == Variable::Place::global && variable.is_in) inputs.insert(variable.name);
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
