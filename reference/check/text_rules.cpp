#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "host/project/tokens.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using Kind = Token::Kind;

constexpr std::string_view vscode_only[] = {"saturate",       "gl_FragColor", "texture2D",   "textureCube",
                                            "GLSL_FRAGCOLOR", "iMouseButton", "iGlobalTime", "iGlobalFrame",
                                            "iKeyboard",      "iChannel4",    "iChannel5",   "iChannel6",
                                            "iChannel7",      "iChannel8",    "iChannel9"};
constexpr std::string_view site_only[] = {"iChannelTime", "iFrameRate", "HW_PERFORMANCE"};

template <std::size_t N>
bool among(const std::string_view (&names)[N], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool starts(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

// Whether the groups of #if around a token are for local hosts only, or for others only.
class Audience {
 public:
  void directive(const std::vector<Token>& tokens, std::size_t hash) {
    if (hash + 1 >= tokens.size()) return;
    const std::string_view name = tokens[hash + 1].text;
    if (name == "ifdef" || name == "ifndef" || name == "if") {
      groups_.push_back(condition(tokens, hash + 2, name));
    } else if (name == "else" && !groups_.empty()) {
      groups_.back() = groups_.back() == Group::local    ? Group::others
                       : groups_.back() == Group::others ? Group::local
                                                         : Group::all;
    } else if (name == "elif" && !groups_.empty()) {
      groups_.back() = Group::all;
    } else if (name == "endif" && !groups_.empty()) {
      groups_.pop_back();
    }
  }

  bool site() const { return std::count(groups_.begin(), groups_.end(), Group::local) == 0; }
  bool extension() const { return std::count(groups_.begin(), groups_.end(), Group::others) == 0; }

 private:
  enum class Group { all, local, others };

  static Group condition(const std::vector<Token>& tokens, std::size_t at, std::string_view name) {
    bool negated = name == "ifndef";
    bool mentioned = false;
    for (; at < tokens.size() && tokens[at].preprocessor && !tokens[at].first; ++at) {
      negated |= tokens[at].is("!");
      mentioned |= tokens[at].is("SHADER_TOY");
    }
    if (!mentioned) return Group::all;
    return negated ? Group::others : Group::local;
  }

  std::vector<Group> groups_;
};

class TextRules {
 public:
  TextRules(const Project& project, const Pass& pass)
      : project_(project), pass_(pass), tokens_(tokenize(pass.source.body)) {}

  std::vector<Finding> findings() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      const Token& token = tokens_[at_];
      if (token.preprocessor) {
        directive();
        continue;
      }
      if (token.kind == Kind::identifier) identifier(token.text);
      before_ = token.text;
      any_code_ = true;
    }
    return std::move(findings_);
  }

 private:
  void add(const std::string& kind, const std::string& text) {
    const auto line = static_cast<std::size_t>(tokens_[at_].line) - 1;
    const SourceLine at = line < pass_.source.lines.size() ? pass_.source.lines[line] : SourceLine{};
    if (at.file < 0) return;  // a define of the command line
    if (told_.insert(text).second) findings_.push_back(make_finding(project_, pass_, at, kind, text));
  }

  void directive() {
    if (!tokens_[at_].first || !tokens_[at_].is("#")) {
      // The text of a macro becomes code where it is used.
      if (tokens_[at_].kind == Kind::identifier && in_define_) identifier(tokens_[at_].text);
      return;
    }
    audience_.directive(tokens_, at_);
    in_define_ = at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("define");
    if (at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("extension") && any_code_ && audience_.site())
      add("webgl2", "#extension behind code: browsers want it in front of everything else");
  }

  // Each name is told once, where it comes first.
  void identifier(std::string_view text) {
    if (audience_.site()) name(text);
    dialect(text);
  }

  void name(std::string_view name) {
    const std::string quoted = "'" + std::string(name) + "'";
    if (name == "__LINE__" || name == "__FILE__" || name == "__VERSION__") return;
    if (name.find("__") != std::string_view::npos)
      add("webgl2", quoted + ": browsers refuse names with two underscores in a row");
    else if (starts(name, "webgl_") || starts(name, "_webgl_"))
      add("webgl2", quoted + ": browsers keep names that start with webgl_ and _webgl_ to themselves");
    else if (name.size() > 1024)
      add("webgl2", "browsers refuse names of more than 1024 characters");
  }

  void dialect(std::string_view name) {
    const bool wrong_here =
        (among(vscode_only, name) && audience_.site()) || (among(site_only, name) && audience_.extension());
    const bool member = before_ == ".";
    if (!wrong_here || member || declares(tokens_, name)) return;
    add("portability",
        "'" + std::string(name) +
            (among(site_only, name) ? "' is there on shadertoy.com, not in the VS Code extension"
                                    : "' is there in the VS Code extension, not on shadertoy.com"));
  }

  const Project& project_;
  const Pass& pass_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  Audience audience_;
  std::string_view before_;
  bool any_code_ = false;
  bool in_define_ = false;
  std::set<std::string> told_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> text_rules(const Project& project) {
  std::vector<Finding> findings;
  for (const Pass& pass : project.passes) {
    for (Finding& finding : TextRules(project, pass).findings()) findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace shadertwin::check
