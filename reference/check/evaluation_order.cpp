#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference/check/parsed_pass.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using namespace glslang;
using emit::Effects;
using emit::SymbolId;

// What one part of an expression does, and the variables that a call takes in through it when it begins.
struct Part {
  Effects effects;
  std::set<SymbolId> taken_in;
};

class OrderFinder : public TIntermTraverser {
 public:
  explicit OrderFinder(const ParsedPass& parsed) : program_(parsed.program), tree_(parsed.tree) {}

  std::vector<std::pair<const TIntermNode*, std::string>> found;

  bool visitBinary(TVisit, TIntermBinary* node) override {
    const TOperator op = node->getOp();
    if (op == EOpComma || op == EOpLogicalAnd || op == EOpLogicalOr) return true;
    const TIntermTyped& left = *node->getLeft();
    const TIntermTyped& right = *node->getRight();
    if (!node->modifiesState()) {
      compare(*node, {{program_.effects(left), {}}, {program_.effects(right), {}}});
    } else if (op == EOpAssign) {
      compare(*node, {{of_indices(left), {}}, {program_.effects(right), {}}});
    } else {
      Effects value = of_indices(left);
      if (const TIntermSymbol* symbol = emit::base_symbol(left)) value.reads.insert(symbol->getId());
      compare(*node, {{value, {}}, {program_.effects(right), {}}});
    }
    return true;
  }

  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    const TOperator op = node->getOp();
    if (op == EOpComma) length_of_call(*node);
    if (op == EOpSequence || op == EOpFunction || op == EOpParameters || op == EOpLinkerObjects ||
        op == EOpComma)
      return true;
    std::vector<Part> arguments;
    const TQualifierList& qualifiers = node->getQualifierList();
    for (std::size_t i = 0; i < node->getSequence().size(); ++i) {
      const TIntermTyped* argument = node->getSequence()[i]->getAsTyped();
      if (argument == nullptr) return true;
      const TStorageQualifier how = i < qualifiers.size() ? qualifiers[i] : EvqIn;
      Part part{emit::is_out(how) ? of_indices(*argument) : program_.effects(*argument), {}};
      if (const TIntermSymbol* symbol = emit::base_symbol(*argument); symbol != nullptr && how == EvqInOut)
        part.taken_in.insert(symbol->getId());
      arguments.push_back(std::move(part));
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

  // A part to the right changes a variable that one to the left only reads: drivers load it when they need
  // it, which may be later. What is changed first is read as changed on every compiler seen, and where both
  // change it, as calls of one random generator do, their order is the text's. What a call takes in, it takes
  // when it begins, or where the argument stands: there compilers differ, whichever is first.
  void compare(const TIntermNode& at, const std::vector<Part>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = 0; k < parts.size(); ++k) {
        if (i == k) continue;
        for (const SymbolId id : parts[i].effects.writes) {
          if (id == emit::Program::control_flow || parts[k].effects.writes.count(id) != 0) continue;
          if (parts[k].taken_in.count(id) != 0)
            add(at, id,
                "is passed as `inout` while another argument changes it: compilers do not agree which value "
                "comes "
                "in");
          else if (k < i && parts[k].effects.reads.count(id) != 0)
            add(at, id, "is read and then changed in one expression: some compilers change it first");
        }
      }
  }

  // The tree has f().length() as (f(), 3).
  void length_of_call(const TIntermAggregate& comma) {
    if (tree_.token_text(comma) == ",") return;
    const TIntermTyped& call = *comma.getSequence()[0]->getAsTyped();
    if (program_.effects(call).writes.empty()) return;
    found.emplace_back(&comma, "a call with effects of which only length() is taken: some compilers drop it");
  }

  void add(const TIntermNode& at, SymbolId id, const std::string& words) {
    NameFinder finder(id);
    const_cast<TIntermNode&>(at).traverse(&finder);
    // Of a global variable that a called function uses there is no symbol here.
    for (const TIntermSymbol* global : program_.globals())
      if (finder.name.empty() && global->getId() == id) finder.name = global->getName().c_str();
    if (!finder.name.empty()) found.emplace_back(&at, "'" + finder.name + "' " + words);
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
  const SyntaxTree& tree_;
};

}  // namespace

std::vector<Finding> evaluation_order(const ParsedPass& parsed) {
  OrderFinder finder(parsed);
  const_cast<TIntermAggregate&>(parsed.tree.root()).traverse(&finder);  // it has no const traversal
  std::vector<Finding> findings;
  for (const auto& [node, words] : finder.found)
    if (const SourceLine line = parsed.tree.line_of(*node); line.file >= 0)
      findings.push_back(make_finding(parsed.project, parsed.pass, line, "portability", words));
  return findings;
}

}  // namespace shadertwin::check
