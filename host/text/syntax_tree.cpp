#include "host/text/syntax_tree.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>

#include <algorithm>
#include <sstream>

#include "host/base/error.h"
#include "host/text/fold.h"
#include "host/text/map_log.h"
#include "host/text/render.h"
#include "host/text/resolve_macros.h"
#include "host/text/switch_labels.h"

namespace shadertwin {
namespace {

constexpr int version = 300;

// glslang's tables of built-ins. They take as long as a large shader to make, so they are kept.
struct Library {
  Library() { glslang::InitializeProcess(); }
  ~Library() { glslang::FinalizeProcess(); }
};

EShMessages messages_for(Errors errors) {
  return errors == Errors::all ? EShMsgCascadingErrors : EShMsgDefault;
}

// glslang numbers its messages by token; map_log wants lines.
// `lines`: of the whole text. What is missing at its end is told behind the last token.
std::string log_by_line(const std::string& log, const std::vector<PlainToken>& tokens, int lines) {
  std::istringstream in(log);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    const std::size_t number = line.find(" 0:");
    const std::size_t end = number == std::string::npos ? number : line.find(':', number + 3);
    // What follows the count of errors says nothing that the errors don't.
    if (end == std::string::npos) continue;
    const int token = std::atoi(line.c_str() + number + 3) - 1;
    if (token < 0) continue;
    const int at =
        token < static_cast<int>(tokens.size()) ? tokens[static_cast<std::size_t>(token)].line : lines;
    out += line.substr(0, number + 3) + std::to_string(at) + line.substr(end) + '\n';
  }
  return out;
}

[[noreturn]] void refuse(const Project& project, const PassSource& source, const std::string& log) {
  std::string text = map_log(project, source, log);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  throw Error(ExitStatus::shader, text.empty() ? "error: the shader does not compile" : text);
}

// Walking a tree takes a little memory from the thread's pool. A parse puts the pool of its own tree there,
// which ends with that tree, while others may still be walked; so this puts back one that outlives them all.
class LastingPool {
 public:
  LastingPool() = default;
  ~LastingPool() {
    thread_local glslang::TPoolAllocator pool;
    glslang::SetThreadPoolAllocator(&pool);
  }
  LastingPool(const LastingPool&) = delete;
  LastingPool& operator=(const LastingPool&) = delete;
};

}  // namespace

SyntaxTree::SyntaxTree(const Project& project, const PassSource& source, Folding folding, Errors errors)
    : project_(project), source_(source), first_body_line_(first_body_line(source)) {
  static const Library library;
  throw_if_refused(source);
  tokens_ = split_tokens(render(source));
  is_precise_ =
      std::any_of(tokens_.begin(), tokens_.end(), [](const PlainToken& t) { return t.text == "precise"; });
  const std::string lines = one_token_a_line(with_kept_labels(tokens_));
  const char* strings = lines.c_str();
  shader_ = std::make_unique<glslang::TShader>(EShLangFragment);
  shader_->setStrings(&strings, 1);
  const LastingPool pool;
  const ConstantFolding guard(folding);
  if (!shader_->parse(GetDefaultResources(), version, EEsProfile, false, false, messages_for(errors)))
    refuse(project, source, log_by_line(shader_->getInfoLog(), tokens_, line_count(render(source))));
  root_ = shader_->getIntermediate()->getTreeRoot()->getAsAggregate();
  declarations_ = std::make_unique<Declarations>(tokens_);
}

std::string type_name(const glslang::TType& type) {
  const bool is_float = type.getBasicType() == glslang::EbtFloat;
  const bool is_int = type.getBasicType() == glslang::EbtInt;
  if (type.isMatrix())
    return "mat" + std::to_string(type.getMatrixCols()) + 'x' + std::to_string(type.getMatrixRows());
  if (type.getVectorSize() == 1) return is_float ? "float" : is_int ? "int" : "uint";
  return (is_float ? "vec" : is_int ? "ivec" : "uvec") + std::to_string(type.getVectorSize());
}

int SyntaxTree::token_of(const TIntermNode& node) const {
  const int token = node.getLoc().line - 1;
  return token < static_cast<int>(tokens_.size()) ? token : -1;
}

const std::string& SyntaxTree::token_text(const TIntermNode& node) const {
  static const std::string none;
  const int token = token_of(node);
  return token < 0 ? none : tokens_[token].text;
}

SourceLine SyntaxTree::line_of(const TIntermNode& node) const {
  return line_of_token(token_of(node));
}

SourceLine SyntaxTree::line_of_token(int token) const {
  if (token < 0) return {};
  const int body_line = tokens_[token].line - first_body_line_;
  if (body_line < 0 || body_line >= static_cast<int>(source_.lines.size())) return {};
  return source_.lines[body_line];
}

std::string SyntaxTree::place_of(const TIntermNode& node) const {
  return place_of_token(token_of(node));
}

std::string SyntaxTree::place_of_token(int token) const {
  const SourceLine line = line_of_token(token);
  if (line.file < 0) return "shader";
  return project_.files[line.file] + ':' + std::to_string(line.line);
}

std::optional<SyntaxTree> parsed(const Project& project, const PassSource& source) {
  try {
    return std::make_optional<SyntaxTree>(project, source, Folding::float32);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace shadertwin
