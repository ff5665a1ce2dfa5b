#include "reference/emit/placement.h"

#include <algorithm>
#include <set>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

// A block on the way from the function's body to a use.
struct EnclosingBlock {
  const Block* block = nullptr;
  int statement = 0;
  // The tokens where the rounds of the loops between this block and the one around it begin: behind the
  // header of a `for`.
  std::vector<int> loops;
  bool is_switch = false;  // C++ can't jump over what is declared here
};

struct Uses {
  const TIntermSymbol* symbol = nullptr;
  std::vector<EnclosingBlock> path;  // of the first use, cut to what all uses share
  int first_token = 0;
};

class UseCollector : public TIntermTraverser {
 public:
  UseCollector(const Program& program, std::set<SymbolId> parameters)
      : program_(program), parameters_(std::move(parameters)) {}

  std::map<SymbolId, Uses> uses;

  void statements(const Block& block, bool is_switch) {
    blocks_.push_back({&block, 0, std::move(loops_), is_switch});
    loops_.clear();
    const TIntermSequence& sequence = block.getSequence();
    for (int i = 0; i < static_cast<int>(sequence.size()); ++i) {
      blocks_.back().statement = i;
      if (is_declaration_list(program_.tree(), *sequence[i])) {
        for (TIntermNode* declaration : sequence[i]->getAsAggregate()->getSequence())
          declaration->traverse(this);
      } else {
        sequence[i]->traverse(this);
      }
    }
    loops_ = std::move(blocks_.back().loops);
    blocks_.pop_back();
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    if (node->getOp() != EOpSequence) return true;
    statements(*node, false);
    return false;
  }

  bool visitSwitch(TVisit, TIntermSwitch* node) override {
    node->getCondition()->traverse(this);
    statements(*node->getBody(), true);
    return false;
  }

  // A swizzle's selectors are a sequence, but no block.
  bool visitBinary(TVisit, TIntermBinary* node) override {
    if (node->getOp() != EOpVectorSwizzle) return true;
    node->getLeft()->traverse(this);
    return false;
  }

  bool visitLoop(TVisit, TIntermLoop* node) override {
    loops_.push_back(first_round(program_.tree().token_of(*node)));
    if (node->getTest() != nullptr) node->getTest()->traverse(this);
    if (node->getBody() != nullptr) node->getBody()->traverse(this);
    if (node->getTerminal() != nullptr) node->getTerminal()->traverse(this);
    loops_.pop_back();
    return false;
  }

  void visitSymbol(TIntermSymbol* symbol) override {
    const SymbolId id = symbol->getId();
    if (program_.is_global(id) || parameters_.count(id) != 0 || symbol->getQualifier().isPipeInput()) return;
    const std::vector<EnclosingBlock>& here = blocks_;
    const auto [found, is_first] = uses.emplace(id, Uses{symbol, here, program_.tree().token_of(*symbol)});
    if (is_first) return;
    std::vector<EnclosingBlock>& shared = found->second.path;
    std::size_t length = 0;
    while (length < std::min(shared.size(), here.size()) && shared[length].block == here[length].block)
      ++length;
    shared.resize(length);
  }

 private:
  int first_round(int keyword) const {
    for (const ForLoop& loop : program_.tree().declarations().loops()) {
      if (loop.open == keyword + 1) return loop.close;
    }
    return keyword;
  }

  const Program& program_;
  std::set<SymbolId> parameters_;
  std::vector<EnclosingBlock> blocks_;
  std::vector<int> loops_;
};

// A variable that is declared in front of a loop keeps its value from round to round, even if every use is
// inside.
bool leaves_loop(const std::vector<EnclosingBlock>& path, int declaration) {
  for (const EnclosingBlock& enclosing : path) {
    for (const int loop : enclosing.loops) {
      if (declaration < loop) return true;
    }
  }
  return false;
}

// Behind a for loop's initialiser and before the loop itself there is no room in C++.
bool is_in_front_of_loop(const Program& program, const EnclosingBlock& enclosing) {
  const TIntermNode* statement = enclosing.block->getSequence()[enclosing.statement];
  return statement->getAsLoopNode() != nullptr && program.tree().token_text(*statement) == "for";
}

}  // namespace

bool is_declaration_list(const SyntaxTree& tree, const TIntermNode& node) {
  const TIntermAggregate* list = node.getAsAggregate();
  if (list == nullptr || list->getOp() != EOpSequence || list->getSequence().empty()) return false;
  return std::all_of(list->getSequence().begin(), list->getSequence().end(), [&](const TIntermNode* child) {
    const TIntermBinary* assignment = child->getAsBinaryNode();
    if (assignment == nullptr || assignment->getOp() != EOpAssign) return false;
    const TIntermSymbol* symbol = assignment->getLeft()->getAsSymbolNode();
    return symbol != nullptr && tree.declarations().is_declaration(tree.token_of(*symbol));
  });
}

bool is_for_loop(const SyntaxTree& tree, const Block& block) {
  const TIntermSequence& parts = block.getSequence();
  return !parts.empty() && parts.back() != nullptr && parts.back()->getAsLoopNode() != nullptr &&
         tree.token_text(*parts.back()) == "for";
}

Placement::Placement(const Program& program, const Function& function) {
  if (function.body == nullptr) return;
  std::set<SymbolId> parameters;
  for (const Parameter& parameter : function.parameters) parameters.insert(parameter.symbol->getId());
  UseCollector collector(program, std::move(parameters));
  collector.statements(*function.body, false);

  std::vector<Uses> variables;
  for (auto& [id, uses] : collector.uses) variables.push_back(std::move(uses));
  std::sort(variables.begin(), variables.end(),
            [](const Uses& a, const Uses& b) { return a.symbol->getId() < b.symbol->getId(); });
  for (Uses& variable : variables) {
    const int declaration = program.tree().declarations().declaration_of(variable.first_token);
    std::vector<EnclosingBlock>& path = variable.path;
    while (path.size() > 1 && (path.back().is_switch || is_in_front_of_loop(program, path.back()) ||
                               (declaration >= 0 && leaves_loop(path, declaration))))
      path.pop_back();
    places_[{path.back().block, path.back().statement}].push_back(variable.symbol);
  }
}

const std::vector<const TIntermSymbol*>& Placement::declared_at(const Block& block, int index) const {
  static const std::vector<const TIntermSymbol*> none;
  const auto found = places_.find({&block, index});
  return found == places_.end() ? none : found->second;
}

}  // namespace shadertwin::emit
