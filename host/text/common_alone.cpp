#include "host/text/common_alone.h"

#include <algorithm>
#include <set>

#include "host/base/error.h"
#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/text/canonicalise.h"
#include "host/text/map_log.h"
#include "host/text/resolve_macros.h"
#include "host/text/syntax_tree.h"

namespace shadertwin {

namespace {

// What shadertoy.com puts in front of Common where it compiles it by itself: nothing that a pass has, but for
// these two uniforms.
constexpr const char* common_head =
    "uniform vec4 iDate;\n"
    "uniform float iSampleRate;\n"
    "out vec4 outColor;\n";

// Finds the first call of a function that is declared only.
class CallFinder : public glslang::TIntermTraverser {
 public:
  explicit CallFinder(const glslang::TIntermAggregate& root) {
    for (const TIntermNode* node : root.getSequence())
      if (const glslang::TIntermAggregate* function = node->getAsAggregate();
          function != nullptr && function->getOp() == glslang::EOpFunction)
        defined_.insert(function->getName().c_str());
    const_cast<glslang::TIntermAggregate&>(root).traverse(this);  // it has no const traversal
  }

  const glslang::TIntermAggregate* found = nullptr;

  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpFunctionCall && node->isUserDefined() && found == nullptr &&
        defined_.count(node->getName().c_str()) == 0)
      found = node;
    return true;
  }

 private:
  std::set<std::string> defined_;
};

// The variables and functions that a text declares: what a type stands before.
std::set<std::string_view> declared_names(const std::vector<Token>& tokens) {
  std::set<std::string_view> names;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const bool typed = tokens[i - 1].kind == Token::Kind::identifier && !tokens[i - 1].is("return");
    if (tokens[i].kind == Token::Kind::identifier && tokens[i + 1].kind != Token::Kind::identifier &&
        (typed || tokens[i - 1].is("}")))
      names.insert(tokens[i].text);
  }
  return names;
}

// Whether a Common that compiles in front of its passes may need one of them: it names what only they are
// given or what is there already, declares a function that it does not define, or ends in the middle of
// something. Most do nothing of the kind, and need not be compiled a second time.
bool may_need_a_pass(const Pass& common, const std::string& head_of_pass) {
  if (!common.source.refused.empty()) return true;
  const std::vector<Token> host_text = tokenize(head_of_pass);
  const std::set<std::string_view> hosts = declared_names(host_text);
  const std::vector<Token> tokens = tokenize(common.source.body);
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].is("{") || tokens[i].is("(")) ++depth;
    if (tokens[i].is("}") || tokens[i].is(")")) --depth;
    const bool is_prototype = depth == 0 && tokens[i].is(";") && i > 0 && tokens[i - 1].is(")");
    const bool is_hosts =
        hosts.contains(tokens[i].text) && !tokens[i].is("iDate") && !tokens[i].is("iSampleRate");
    if (is_prototype || is_hosts || tokens[i].is("outColor")) return true;
  }
  return depth != 0 || (!tokens.empty() && !tokens.back().is("}") && !tokens.back().is(";"));
}

// The first error of a text; empty if it compiles.
std::string first_error(const Project& project, const PassSource& source) {
  try {
    const SyntaxTree tree(project, source, Folding::float32);
    if (const auto* call = CallFinder(tree.root()).found)
      return tree.place_of(*call) + ": error: a function is called that is defined elsewhere";
  } catch (const Error& error) {
    const std::string text = error.what();
    return text.substr(0, text.find('\n'));
  }
  return "";
}

}  // namespace

std::size_t own_lines(const Pass& pass) {
  std::string_view code = pass.code;
  code = code.substr(0, code.find_last_not_of(" \t") + 1);
  const auto ends = static_cast<std::size_t>(std::count(code.begin(), code.end(), '\n'));
  return std::min(ends + (code.empty() || code.back() == '\n' ? 0 : 1), pass.source.lines.size());
}

std::optional<Pass> common_alone(const Project& project) {
  if (!host_rules(project).common_stands_alone || project.common.empty()) return std::nullopt;
  const Pass& pass = project.passes.back();
  Pass common;
  common.name = "Common";
  common.source.head = common_head;
  common.source.own_output = true;
  common.source.tail = "\nvoid main() { }\n";
  const std::size_t count = pass.source.lines.size() - own_lines(pass);
  common.source.lines.assign(pass.source.lines.begin(),
                             pass.source.lines.begin() + static_cast<std::ptrdiff_t>(count));
  // As it is written: a comment, an #if or a macro's arguments may end in the pass.
  const std::string& written = pass.source.written;
  common.source.body = written.substr(0, begin_of_line(written, count));
  resolve_macros(project, common.source, ShaderStage::fragment);
  common.source.body = canonicalise(common.source.body);
  return common;
}

std::string warning_of_common(const Project& project) {
  const std::optional<Pass> common = common_alone(project);
  if (!common || !may_need_a_pass(*common, project.passes.back().source.head)) return "";
  std::string error = first_error(project, common->source);
  const std::string word = ": error: ";
  const std::size_t at = error.find(word);
  if (at == std::string::npos || !first_error(project, project.passes.back().source).empty()) return "";
  return error.replace(at, word.size(),
                       ": warning: shadertoy.com compiles Common by itself, too, and refuses it: ");
}

}  // namespace shadertwin
