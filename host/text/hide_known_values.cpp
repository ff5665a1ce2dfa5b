#include "host/text/hide_known_values.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/text/operands.h"
#include "host/text/rewritten_lines.h"
#include "host/text/syntax_tree.h"

namespace shadertwin {
namespace {

// What is computed by other steps where its arguments are known. What IEEE rounds has one result.
const std::map<glslang::TOperator, std::string_view>& approximated() {
  static const std::map<glslang::TOperator, std::string_view> functions = {
      {glslang::EOpSin, "sin"},     {glslang::EOpCos, "cos"},     {glslang::EOpTan, "tan"},
      {glslang::EOpAsin, "asin"},   {glslang::EOpAcos, "acos"},   {glslang::EOpAtan, "atan"},
      {glslang::EOpSinh, "sinh"},   {glslang::EOpCosh, "cosh"},   {glslang::EOpTanh, "tanh"},
      {glslang::EOpAsinh, "asinh"}, {glslang::EOpAcosh, "acosh"}, {glslang::EOpAtanh, "atanh"},
      {glslang::EOpExp, "exp"},     {glslang::EOpLog, "log"},     {glslang::EOpExp2, "exp2"},
      {glslang::EOpLog2, "log2"},   {glslang::EOpPow, "pow"},     {glslang::EOpInverseSqrt, "inversesqrt"},
  };
  return functions;
}

constexpr std::string_view helpers = " uniform uint shadertwin_zero;";  // nobody sets it: 0

class Hider : public glslang::TIntermTraverser {
 public:
  explicit Hider(const SyntaxTree& tree) : tree_(tree), tokens_(tree.tokens()), edits_(tokens_) {}

  bool found = false;

  std::vector<std::string> lines(int count) const { return edits_.lines(count); }

  // The tree has the token of a single argument, not that of the call.
  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    const auto function = approximated().find(node->getOp());
    if (function == approximated().end()) return true;
    for (int open = enclosing_bracket(tokens_, tree_.token_of(*node)); open > 0;
         open = enclosing_bracket(tokens_, open)) {
      if (text(open - 1) != function->second || !calls_.insert(open).second) continue;
      hide(open + 1, closing_bracket(tokens_, open) - 1);
      break;
    }
    return true;
  }

  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    const auto function = approximated().find(node->getOp());
    if (function == approximated().end()) return true;
    const int name = name_of_call(tokens_, tree_.token_of(*node));
    if (text(name) != function->second) return true;
    const glslang::TIntermSequence& arguments = node->getSequence();
    const std::vector<TokenRange> ranges = arguments_of(tokens_, name + 1, arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (arguments[i]->getAsTyped()->getAsConstantUnion() == nullptr) hide(ranges[i].first, ranges[i].last);
    return true;
  }

 private:
  const std::string& text(int token) const { return text_at(tokens_, token); }

  void hide(int first, int last) {
    edits_.before[static_cast<std::size_t>(first)] = "uintBitsToFloat(floatBitsToUint(";
    edits_.after[static_cast<std::size_t>(last)] = ") ^ shadertwin_zero)";
    found = true;
  }

  const SyntaxTree& tree_;
  const std::vector<PlainToken>& tokens_;
  RewrittenLines edits_;
  std::set<int> calls_;  // opening parentheses of those with a single argument
};

}  // namespace

PassSource hide_known_values(const Project& project, const PassSource& source) {
  const SyntaxTree tree(project, source, Folding::float32);
  Hider hider(tree);
  const_cast<glslang::TIntermAggregate&>(tree.root()).traverse(&hider);  // it has no const traversal
  if (!hider.found) return source;
  const SectionLines sections(source);
  PassSource result = sections.split(hider.lines(sections.all()));
  result.helpers.insert(0, helpers);  // in front of functions that use it
  return result;
}

}  // namespace shadertwin
