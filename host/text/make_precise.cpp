#include "host/text/make_precise.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/text/operands.h"
#include "host/text/rewritten_lines.h"
#include "host/text/syntax_tree.h"

namespace shadertwin {
namespace {

// Variables of every function that take what no variable of the user's takes. A compiler keeps to the order
// of what is assigned to a precise variable, but not of what is returned or tested directly.
constexpr const char* result_name = "shadertwin_result";
constexpr const char* test_name = "shadertwin_test";
constexpr const char* argument_name = "shadertwin_argument_";  // and a number

// An argument that a shader's own function is called with, and its type. A compiler doesn't keep to the order
// of what is passed directly, either.
struct Argument {
  TokenRange range;
  std::string type;
  std::string sizes;  // of an array: [2]
};

class ArgumentFinder : public glslang::TIntermTraverser {
 public:
  explicit ArgumentFinder(const SyntaxTree& tree) : tree_(tree), tokens_(tree.tokens()) {}

  std::vector<Argument> found;

  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() != glslang::EOpFunctionCall) return true;
    const int open = name_of_call(tokens_, tree_.token_of(*node)) + 1;
    if (text_at(tokens_, open) != "(") return true;
    const glslang::TQualifierList& qualifiers = node->getQualifierList();
    const std::vector<TokenRange> ranges = arguments_of(tokens_, open, node->getSequence().size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const bool comes_in =
          i < qualifiers.size() && qualifiers[i] != glslang::EvqOut && qualifiers[i] != glslang::EvqInOut;
      const glslang::TIntermTyped* argument = node->getSequence()[i]->getAsTyped();
      if (comes_in && argument != nullptr && computes(*argument)) add(ranges[i], argument->getType());
    }
    return true;
  }

 private:
  void add(const TokenRange& range, const glslang::TType& type) {
    Argument argument{range, "", ""};
    if (type.isStruct()) {
      argument.type = type.getTypeName().c_str();
      if (!is_global(argument.type)) return;
    } else if (type.getBasicType() == glslang::EbtBool) {
      argument.type = type.getVectorSize() == 1 ? "bool" : "bvec" + std::to_string(type.getVectorSize());
    } else {
      argument.type = type_name(type);
    }
    if (type.isArray()) argument.sizes = '[' + std::to_string(type.getOuterArraySize()) + ']';
    found.push_back(std::move(argument));
  }

  // Whether a structure is declared outside of functions.
  bool is_global(const std::string& structure) const {
    int braces = 0;
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      if (tokens_[i].text == "{") ++braces;
      if (tokens_[i].text == "}") --braces;
      if (braces == 0 && tokens_[i].text == "struct" && tokens_[i + 1].text == structure) return true;
    }
    return false;
  }

  // By operators: what a variable, a constant or a function gives is not computed here. Integers have one
  // result.
  static bool computes(const glslang::TIntermTyped& argument) {
    const glslang::TBasicType type = argument.getType().getBasicType();
    if (type != glslang::EbtFloat && type != glslang::EbtBool && type != glslang::EbtStruct) return false;
    if (const auto* part = argument.getAsBinaryNode())
      return part->getOp() != glslang::EOpIndexDirect && part->getOp() != glslang::EOpIndexIndirect &&
             part->getOp() != glslang::EOpIndexDirectStruct && part->getOp() != glslang::EOpVectorSwizzle;
    if (const auto* call = argument.getAsAggregate()) return call->getOp() != glslang::EOpFunctionCall;
    return argument.getAsSymbolNode() == nullptr && argument.getAsConstantUnion() == nullptr;
  }

  const SyntaxTree& tree_;
  const std::vector<PlainToken>& tokens_;
};

class PreciseText {
 public:
  explicit PreciseText(const SyntaxTree& tree)
      : tokens_(tree.tokens()), declarations_(tree.declarations()), edits_(tokens_) {
    ArgumentFinder finder(tree);
    const_cast<glslang::TIntermAggregate&>(tree.root()).traverse(&finder);  // it has no const traversal
    arguments_ = std::move(finder.found);
    for (int i = 0; i < size(); ++i) {
      if (declarations_.is_declaration(i)) mark_declaration(i);
    }
    mark_statements();
  }

  std::vector<std::string> lines(int line_count) const { return edits_.lines(line_count); }

 private:
  int size() const { return static_cast<int>(tokens_.size()); }
  const std::string& text(int token) const { return text_at(tokens_, token); }

  // `precise` stands in front of all that belongs to the declaration of token `name`.
  void mark_declaration(int name) {
    int start = name;
    int depth = 0;
    while (start > 0) {
      const std::string& previous = text(start - 1);
      if (previous == ")" || previous == "]") ++depth;
      if ((previous == "(" || previous == "[") && depth-- == 0) break;
      if (depth <= 0 && (previous == ";" || previous == "{" || previous == "}" || previous == "," ||
                         previous == ":" || previous == "else" || previous == "do" || previous[0] == '#'))
        break;
      // The header of a loop or a condition ends in front of the statement; layout(...) does not.
      if (previous == ")" && depth == 1 && text(opening_bracket(tokens_, start - 1) - 1) != "layout") break;
      --start;
    }
    static const std::set<std::string> not_computed = {"const",     "uniform",   "in",
                                                       "sampler2D", "sampler3D", "samplerCube"};
    bool is_parameter = text(start - 1) == "(" || text(start - 1) == ",";
    if (start == name) return;  // a further name of a declaration
    for (int i = start; i < name; ++i) {
      const bool reads_only = text(i) == "in" || text(i) == "const";
      if (text(i) == "struct" || (not_computed.count(text(i)) != 0 && !(is_parameter && reads_only))) return;
    }
    before_[start] = "precise " + before_[start];
  }

  int end_of_statement(int token) const {
    while (token < size() && text(token) != ";") ++token;
    return token;
  }

  void assign(const std::string& variable, int first, int end) {
    if (first >= end || declares(first, end)) return;
    before_[first] = "(" + variable + " = (" + before_[first];
    after_[end - 1] += "))";
  }

  bool declares(int first, int end) const {
    for (int i = first; i < end; ++i) {
      if (declarations_.is_declaration(i)) return true;
    }
    return false;
  }

  void mark_statements() {
    int depth = 0;
    int start = 0;  // of what stands outside of functions
    bool returns_one_value = false;
    for (int i = 0; i < size(); ++i) {
      const std::string& token = text(i);
      if (token == "{" && depth++ == 0) {
        const bool is_function = text(i - 1) == ")";
        returns_one_value = is_function && text(start) != "void" && text(start + 1) != "[";
        if (is_function) after_[i] += std::string(" precise bool ") + test_name + ";";
        if (returns_one_value) after_[i] += " precise " + text(start) + ' ' + result_name + ";";
        if (is_function) mark_arguments({i, closing_bracket(tokens_, i)});
      }
      if (token == "}") --depth;
      if (depth == 0 && (token == ";" || token == "}" || token[0] == '#')) start = skip_qualifiers(i + 1);
      if (depth == 0) continue;
      if (token == "if" || token == "while") assign(test_name, i + 2, closing_bracket(tokens_, i + 1));
      if (token == "for") {
        const int condition = end_of_statement(i) + 1;
        assign(test_name, condition, end_of_statement(condition));
      }
      if (token == "return" && returns_one_value) assign(result_name, i + 1, end_of_statement(i));
    }
  }

  // Each in a variable of its own: of two assignments to one, a compiler may pass on the last result twice.
  void mark_arguments(const TokenRange& body) {
    for (std::size_t i = 0; i < arguments_.size(); ++i) {
      const auto& [range, type, sizes] = arguments_[i];
      if (range.first < body.first || range.last > body.last) continue;
      const std::string name = argument_name + std::to_string(i);
      after_[body.first] += " precise " + type + ' ' + name + sizes + ";";
      assign(name, range.first, range.last + 1);
    }
  }

  int skip_qualifiers(int token) const {
    static const std::set<std::string> precisions = {"highp", "mediump", "lowp"};
    while (precisions.count(text(token)) != 0) ++token;
    return token;
  }

  const std::vector<PlainToken>& tokens_;
  const Declarations& declarations_;
  std::vector<Argument> arguments_;
  RewrittenLines edits_;
  std::vector<std::string>& before_ = edits_.before;
  std::vector<std::string>& after_ = edits_.after;
};

}  // namespace

PassSource make_precise(const Project& project, const PassSource& source) {
  const SyntaxTree tree(project, source, Folding::float32);
  const SectionLines sections(source);
  PassSource result = sections.split(PreciseText(tree).lines(sections.all()));
  result.precise = true;
  return result;
}

}  // namespace shadertwin
