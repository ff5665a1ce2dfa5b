#include "host/text/storage.h"

#include <algorithm>
#include <map>
#include <optional>

#include "host/base/error.h"

namespace shadertwin {
namespace {

using namespace glslang;

constexpr std::int64_t too_many = std::int64_t{1} << 40;

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
class Measurer : public TIntermTraverser {
 public:
  std::map<long long, const TIntermSymbol*> symbols;
  std::int64_t temporaries = 0;

  std::int64_t components(const TType& type) {
    std::int64_t one = 0;
    if (type.isStruct())
      one = members(type.getStruct());
    else if (type.isMatrix())
      one = std::int64_t{type.getMatrixCols()} * type.getMatrixRows();
    else
      one = type.getVectorSize();
    if (type.isArray())
      for (int i = 0; i < type.getArraySizes()->getNumDims(); ++i)
        one = limited(one * type.getArraySizes()->getDimSize(i));
    return one;
  }

  void visitSymbol(TIntermSymbol* symbol) override { symbols.emplace(symbol->getId(), symbol); }
  bool visitAggregate(TVisit, TIntermAggregate* node) override {
    const TType& type = node->getType();
    if (type.isArray() || type.isStruct()) temporaries = limited(temporaries + components(type));
    return true;
  }

 private:
  static std::int64_t limited(std::int64_t count) { return std::min(count, too_many); }

  std::int64_t members(const TTypeList* list) {
    const auto [entry, is_new] = structures_.try_emplace(list, 0);
    if (!is_new) return entry->second;
    std::int64_t sum = 0;
    for (const TTypeLoc& member : *list) sum = limited(sum + components(*member.type));
    return structures_[list] = sum;
  }

  std::map<const TTypeList*, std::int64_t> structures_;
};

// A global variable that nothing uses stands for no token, a parameter for one beside its name.
int declaration_of(const SyntaxTree& tree, const TIntermSymbol& symbol) {
  const Declarations& declarations = tree.declarations();
  if (const int found = declarations.declaration_of(tree.token_of(symbol)); found >= 0) return found;
  for (const Variable& variable : declarations.variables())
    if (variable.place == Variable::Place::global && variable.name >= 0 &&
        tree.tokens()[static_cast<std::size_t>(variable.name)].text == symbol.getName().c_str())
      return variable.name;
  return tree.token_of(symbol);
}

}  // namespace

Storage measure_storage(const SyntaxTree& tree) {
  Measurer measurer;
  const_cast<TIntermAggregate&>(tree.root()).traverse(&measurer);  // it has no const traversal
  Storage storage;
  storage.temporaries = measurer.temporaries;
  for (const auto& [id, symbol] : measurer.symbols) {
    if (!is_variable(symbol->getQualifier().storage)) continue;
    const std::int64_t components = measurer.components(symbol->getType());
    storage.variables = std::min(storage.variables + components, too_many);
    if (components > most_components)
      storage.large.push_back({symbol->getName().c_str(), declaration_of(tree, *symbol)});
  }
  return storage;
}

Storage measure_allowed_storage(const SyntaxTree& tree) {
  Storage storage = measure_storage(tree);
  if (!storage.large.empty()) {
    const LargeVariable& variable = storage.large.front();
    throw Error(ExitStatus::shader, tree.place_of_token(variable.token) + ": error: '" + variable.name +
                                        "' has 64 KB or more, which browsers refuse");
  }
  if (storage.is_too_large_together())
    throw Error(ExitStatus::shader,
                "error: the variables of the shader have more than 16 MB together, which browsers refuse");
  return storage;
}

void refuse_large_variables(const Project& project, const PassSource& source) {
  if (const std::optional<SyntaxTree> tree = parsed(project, source)) measure_allowed_storage(*tree);
}

}  // namespace shadertwin
