#include <algorithm>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;
using emit::Effects;
using emit::SymbolId;

class OrderFinder : public TIntermTraverser {
 public:
  struct Found {
    const TIntermNode* at = nullptr;
    std::string name;
  };

  explicit OrderFinder(const emit::Program& program) : program_(program) {}

  std::vector<Found> found;

  bool visitBinary(TVisit, TIntermBinary* node) override {
    const TOperator op = node->getOp();
    if (op == EOpComma || op == EOpLogicalAnd || op == EOpLogicalOr) return true;
    const TIntermTyped& left = *node->getLeft();
    const TIntermTyped& right = *node->getRight();
    if (!node->modifiesState()) {
      compare(*node, {program_.effects(left), program_.effects(right)});
    } else if (op == EOpAssign) {
      compare(*node, {of_indices(left), program_.effects(right)});
    } else {
      Effects value = of_indices(left);
      if (const TIntermSymbol* symbol = emit::base_symbol(left)) value.reads.insert(symbol->getId());
      compare(*node, {value, program_.effects(right)});
    }
    return true;
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    const TOperator op = node->getOp();
    if (op == EOpSequence || op == EOpFunction || op == EOpParameters || op == EOpLinkerObjects ||
        op == EOpComma)
      return true;
    std::vector<Effects> arguments;
    const TQualifierList& qualifiers = node->getQualifierList();
    for (std::size_t i = 0; i < node->getSequence().size(); ++i) {
      const TIntermTyped* argument = node->getSequence()[i]->getAsTyped();
      if (argument == nullptr) return true;
      const TStorageQualifier how = i < qualifiers.size() ? qualifiers[i] : EvqIn;
      Effects effects = emit::is_out(how) ? of_indices(*argument) : program_.effects(*argument);
      // What comes in through it is read when the call begins, or before: there compilers differ.
      if (const TIntermSymbol* symbol = emit::base_symbol(*argument); symbol != nullptr && how == EvqInOut)
        effects.reads.insert(symbol->getId());
      arguments.push_back(std::move(effects));
    }
    compare(*node, arguments);
    return true;
  }

 private:
  // Of an l-value: what evaluating its indices reads and writes.
  Effects of_indices(const TIntermTyped& lvalue) const {
    Effects effects;
    const TIntermTyped* node = &lvalue;
    while (const TIntermBinary* binary = node->getAsBinaryNode()) {
      if (binary->getOp() == EOpIndexIndirect) effects.add(program_.effects(*binary->getRight()));
      node = binary->getLeft();
    }
    return effects;
  }

  // One part changes a variable that another one only reads. Where all of them change it, as calls of one
  // random generator do, their order is the text's on every compiler seen.
  void compare(const TIntermNode& at, const std::vector<Effects>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = 0; k < parts.size(); ++k) {
        if (i == k) continue;
        for (const SymbolId id : parts[i].writes)
          if (id != emit::Program::control_flow && parts[k].reads.count(id) != 0 &&
              parts[k].writes.count(id) == 0)
            add(at, id);
      }
  }

  void add(const TIntermNode& at, SymbolId id) {
    NameFinder finder(id);
    const_cast<TIntermNode&>(at).traverse(&finder);
    // Of a global variable that a called function uses there is no symbol here.
    for (const TIntermSymbol* global : program_.globals())
      if (finder.name.empty() && global->getId() == id) finder.name = global->getName().c_str();
    if (!finder.name.empty()) found.push_back({&at, finder.name});
  }

  class NameFinder : public TIntermTraverser {
   public:
    explicit NameFinder(SymbolId id) : id_(id) {}
    void visitSymbol(TIntermSymbol* symbol) override {
      if (symbol->getId() == id_) name = symbol->getName().c_str();
    }
    std::string name;

   private:
    SymbolId id_;
  };

  const emit::Program& program_;
};

}  // namespace

std::vector<Finding> evaluation_order(const ParsedPass& parsed) {
  OrderFinder finder(parsed.program);
  const_cast<TIntermAggregate&>(parsed.tree.root()).traverse(&finder);  // it has no const traversal
  std::vector<Finding> findings;
  for (const OrderFinder::Found& found : finder.found)
    if (const SourceLine line = parsed.tree.line_of(*found.at); line.file >= 0)
      findings.push_back(make_finding(parsed.project, parsed.pass, line, "portability",
                                      "'" + found.name +
                                          "' is read and changed in one expression: compilers do not agree "
                                          "which comes first"));
  return findings;
}

}  // namespace shadertwin::check
