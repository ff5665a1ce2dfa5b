#include "host/text/define_undefined.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "host/base/error.h"
#include "host/text/define_operations.h"
#include "host/text/loop_range.h"
#include "host/text/main_text.h"
#include "host/text/operands.h"
#include "host/text/render.h"
#include "host/text/resolve_macros.h"
#include "host/text/rewritten_lines.h"
#include "host/text/storage.h"
#include "host/text/syntax_tree.h"
#include "host/text/zero_values.h"

namespace shadertwin {
namespace {

// Clamps an index; stands in the head, where no macro of the user's has a meaning yet.
constexpr const char* clamp_name = "shadertwin_at";
constexpr const char* clamp_functions =
    " int shadertwin_at(int i, int last) { return clamp(i, 0, last); }"
    " int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }";

// How many elements there are to choose from, by the `[` of every index that is no constant.
using Choices = std::map<int, int>;

class ChoiceFinder : public glslang::TIntermTraverser {
 public:
  explicit ChoiceFinder(const SyntaxTree& tree) : tree_(tree) {}

  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    if (node->getOp() != glslang::EOpIndexIndirect) return true;
    const glslang::TType& type = node->getLeft()->getType();
    const int count = type.isArray()    ? type.getOuterArraySize()
                      : type.isMatrix() ? type.getMatrixCols()
                                        : type.getVectorSize();
    if (const int token = tree_.token_of(*node); token >= 0 && count > 0) choices[token] = count;
    return true;
  }

  Choices choices;

 private:
  const SyntaxTree& tree_;
};

class DefinedText {
 public:
  DefinedText(const std::vector<PlainToken>& tokens, const Declarations& declarations)
      : tokens_(tokens), declarations_(declarations), values_(tokens, declarations), edits_(tokens) {}

  void define_variables() {
    for (const Variable& variable : declarations_.variables()) {
      const bool stored = variable.place != Variable::Place::parameter && !variable.is_const &&
                          !variable.is_uniform && !variable.is_in && !variable.is_out;
      if (!stored || variable.initialised || variable.name < 0) continue;
      if (const std::string zero = values_.of(variable); !zero.empty())
        edits_.after[variable.end - 1] += " = " + zero;
      else if (variable.place == Variable::Place::local)
        clear_behind(variable);
      else
        globals_.push_back(&variable);
    }
  }

  void define_functions(bool own_main) {
    for (const FunctionBody& function : declarations_.functions()) {
      std::string& start = edits_.after[function.open];
      for (std::size_t i = 0; i < function.parameters; ++i) {
        const Variable& parameter = declarations_.variables()[function.first_parameter + i];
        if (parameter.is_out && !parameter.is_in && parameter.name >= 0) start += assigned_zero(parameter);
      }
      if (text(function.name) == "main" && own_main) start += zero_outputs(function);
      if (!function.returns_last && returns(function))
        if (const std::string zero = values_.of_result(function); !zero.empty())
          edits_.before[function.close] += "return " + zero + "; ";
    }
    clear_globals();
  }

  void clamp_indices(const Choices& choices) {
    for (const auto& [open, count] : choices) {
      const int close = closing_bracket(tokens_, open);
      const bool single = close == open + 2;
      if (single && stays_below(tokens_, declarations_, values_, open + 1, count)) continue;
      edits_.after[open] += std::string(clamp_name) + (single ? "(" : "((");
      edits_.before[close] = (single ? ", " : "), ") + std::to_string(count - 1) + ")" + edits_.before[close];
    }
  }

  RewrittenLines& edits() { return edits_; }

 private:
  const std::string& text(int token) const { return text_at(tokens_, token); }

  bool returns(const FunctionBody& function) const {
    for (int i = function.open; i < function.close; ++i) {
      if (text(i) == "return" && text(i + 1) != ";") return true;
    }
    return false;
  }

  bool in_header(const Variable& variable) const {
    return std::any_of(declarations_.loops().begin(), declarations_.loops().end(), [&](const ForLoop& loop) {
      return variable.name > loop.open && variable.name < loop.close;
    });
  }

  // A statement that makes a variable zero; empty if there is none.
  std::string assigned_zero(const Variable& variable) const {
    const std::string name = " " + text(variable.name);
    if (const std::string zero = values_.of(variable); !zero.empty()) return name + " = " + zero + ";";
    const std::string zero = values_.of_element(variable);
    if (zero.empty()) return {};
    return " for (int shadertwin_i = 0; shadertwin_i <" + name + ".length(); ++shadertwin_i)" + name +
           "[shadertwin_i] = " + zero + ";";
  }

  // A long array is cleared by a loop behind its declaration, if that stands in a block.
  void clear_behind(const Variable& variable) {
    int first = variable.type - 1;
    while (text(first) == "highp" || text(first) == "mediump" || text(first) == "lowp") --first;
    const std::string& before = text(first);
    if (in_header(variable) || (before != ";" && before != "{" && before != "}" && before != ":")) return;
    int end = variable.end;
    for (int depth = 0; !text(end).empty(); ++end) {
      if (text(end) == "(" || text(end) == "{") ++depth;
      if (text(end) == ")" || text(end) == "}") --depth;
      if (depth == 0 && text(end) == ";") break;
    }
    if (!text(end).empty()) edits_.after[end] += assigned_zero(variable);
  }

  // Long global arrays are cleared where the shader starts. It must start once, and behind them.
  void clear_globals() {
    const FunctionBody* entry = nullptr;
    for (const FunctionBody& function : declarations_.functions()) {
      if (is_entry_point(text(function.name))) entry = &function;
    }
    if (entry == nullptr) return;
    for (const Variable* variable : globals_) {
      if (variable->name < entry->open) edits_.after[entry->open] += assigned_zero(*variable);
    }
  }

  std::string zero_outputs(const FunctionBody& main) const {
    std::string text;
    for (const Variable& variable : declarations_.variables()) {
      if (variable.place == Variable::Place::global && variable.is_out && variable.name < main.name)
        text += assigned_zero(variable);
    }
    return text;
  }

  const std::vector<PlainToken>& tokens_;
  const Declarations& declarations_;
  ZeroValues values_;
  RewrittenLines edits_;
  std::vector<const Variable*> globals_;
};

Choices find_choices(const SyntaxTree& tree) {
  ChoiceFinder finder(tree);
  const_cast<glslang::TIntermAggregate&>(tree.root()).traverse(&finder);
  return finder.choices;
}

}  // namespace

std::optional<PassSource> define_undefined(const Project& project, const PassSource& source) {
  const std::optional<SyntaxTree> tree = parsed(project, source);
  if (tree) measure_allowed_storage(*tree);
  try {
    throw_if_refused(source);
    const std::vector<PlainToken> tokens = tree ? tree->tokens() : split_tokens(render(source));
    const Declarations declarations(tokens);
    DefinedText text(tokens, declarations);
    text.define_variables();
    const SectionLines sections(source);
    const bool own_main = std::any_of(
        declarations.functions().begin(), declarations.functions().end(), [&](const FunctionBody& f) {
          return tokens[f.name].text == "main" && sections.in_body(tokens[f.name].line);
        });
    text.define_functions(own_main);
    std::string functions;
    if (tree) {
      const Choices choices = find_choices(*tree);
      text.clamp_indices(choices);
      functions = define_operations(*tree, text.edits());
      if (!choices.empty()) functions += clamp_functions;
    }
    PassSource result = sections.split(text.edits().lines(sections.all()));
    result.helpers += functions;
    return result;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace shadertwin
