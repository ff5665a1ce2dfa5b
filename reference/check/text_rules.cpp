#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"
#include "host/text/common_alone.h"
#include "host/text/map_log.h"
#include "host/text/resolve_macros.h"
#include "host/text/text_warnings.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using Kind = Token::Kind;

template <std::size_t N>
bool among(const std::string_view (&names)[N], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

constexpr std::string_view vscode_only[] = {"saturate",       "gl_FragColor", "texture2D",    "textureCube",
                                            "GLSL_FRAGCOLOR", "iMouseButton", "iGlobalTime",  "iGlobalFrame",
                                            "iKeyboard",      "isKeyDown",    "isKeyPressed", "isKeyToggled",
                                            "isKeyReleased",  "iViewMatrix",  "iChannel4",    "iChannel5",
                                            "iChannel6",      "iChannel7",    "iChannel8",    "iChannel9"};
constexpr std::string_view site_only[] = {"iChannelTime", "iFrameRate", "HW_PERFORMANCE"};
constexpr std::string_view channel_structs[] = {"iCh0", "iCh1", "iCh2", "iCh3"};

// What stands in front of the user's text on shadertoy.com, so that the text can't declare it again.
constexpr std::string_view site_uniforms[] = {"iResolution",  "iTime",
                                              "iTimeDelta",   "iFrame",
                                              "iFrameRate",   "iDate",
                                              "iMouse",       "iSampleRate",
                                              "iChannel0",    "iChannel1",
                                              "iChannel2",    "iChannel3",
                                              "iChannelTime", "iChannelResolution"};
// The same around single kinds of passes.
bool is_global_of_site(PassKind kind, std::string_view name) {
  switch (kind) {
    case PassKind::image:
      return among(channel_structs, name);
    case PassKind::cubemap:
      return name == "outColor" || name == "unViewport" || name == "unCorners";
    default:
      return name == "outColor";
  }
}

// The same in the extension, beyond its uniforms.
constexpr std::string_view vscode_globals[] = {"viewMatrix", "cameraPosition", "isOrthographic"};

// Whether shadertoy.com alone calls a function of that name.
bool is_site_entry(std::string_view name) {
  return std::any_of(pass_kinds.begin(), pass_kinds.end(),
                     [&](const PassTraits& kind) { return !kind.in_extension && kind.entry == name; });
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
  // `text`: the pass's body, or Common and the pass as the user wrote them, from its line `first_line` (from
  // 0).
  TextRules(const Project& project, const Pass& pass, std::string_view text, std::size_t first_line = 0)
      : project_(project), pass_(pass), first_line_(first_line), tokens_(tokenize(text)) {}

  std::vector<Finding> findings() {
    note_code();
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      const Token& token = tokens_[at_];
      if (token.preprocessor) {
        directive();
        continue;
      }
      if (is_skipped_here(token)) continue;
      if (token.is("{") || token.is("(")) ++depth_;
      if (token.is("}") || token.is(")")) depth_ = std::max(depth_ - 1, 0);
      if (token.kind == Kind::identifier) identifier(token.text);
      if (token.kind == Kind::identifier && !before_.empty()) declaration(token.text);
      before_ = token.kind == Kind::identifier || token.is(".") || token.is("]") ? token.text : "";
    }
    for (const std::size_t open : open_) {
      at_ = open;
      add("webgl2", "there is no #endif for this");
    }
    return std::move(findings_);
  }

  // What the body no longer has: iCh0 to iCh3, and directives that native compilers would stumble over.
  std::vector<Finding> findings_as_written() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      if (tokens_[at_].first && tokens_[at_].is("#")) {
        audience_.directive(tokens_, at_);
        if (audience_.site()) dropped_directive();
      }
      if (!among(channel_structs, tokens_[at_].text) || declares(tokens_, tokens_[at_].text)) continue;
      const std::string name = "'" + std::string(tokens_[at_].text) + "'";
      if (pass_.kind != PassKind::image && audience_.site())
        own_host(name + " is there in the Image pass only");
      else if (audience_.extension())
        add("portability", name + " is there on shadertoy.com, not in the VS Code extension");
    }
    return std::move(findings_);
  }

 private:
  void add(const std::string& kind, const std::string& text) {
    const auto line = first_line_ + static_cast<std::size_t>(tokens_[at_].line) - 1;
    const SourceLine at = line < pass_.source.lines.size() ? pass_.source.lines[line] : SourceLine{};
    if (at.file < 0) return;  // a define of the command line
    if (told_.insert(text).second) findings_.push_back(make_finding(project_, pass_, at, kind, text));
  }

  // What the preprocessor leaves of the text, and which names it replaces.
  void note_code() {
    PassSource plain = pass_.source;
    plain.body = plain.written;
    resolve_macros(project_, plain, ShaderStage::fragment);
    has_code_.resize(pass_.source.lines.size() + 2);
    for (const Token& token : tokenize(plain.body))
      if (const auto line = static_cast<std::size_t>(token.line); line < has_code_.size())
        has_code_[line] = true;
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
      if (tokens_[i].first && tokens_[i].is("#") && tokens_[i + 1].is("define"))
        macros_.insert(tokens_[i + 2].text);
  }

  // Groups that ask for a local host are judged for either host, the others as they are resolved here.
  bool is_skipped_here(const Token& token) const {
    const auto line = static_cast<std::size_t>(token.line);
    return audience_.site() && audience_.extension() && line < has_code_.size() && !has_code_[line];
  }

  void directive() {
    if (!tokens_[at_].first || !tokens_[at_].is("#")) {
      // The text of a macro becomes code where it is used.
      if (tokens_[at_].kind == Kind::identifier && in_define_) identifier(tokens_[at_].text);
      return;
    }
    audience_.directive(tokens_, at_);
    group();
    in_define_ = at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("define");
    if (in_define_ && at_ + 2 < tokens_.size() && tokens_[at_ + 2].preprocessor) macro(tokens_[at_ + 2].text);
    // Behind the shader's own code it is refused already.
    if (at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("extension") && audience_.site() &&
        pass_.source.refused.empty())
      add("webgl2", "#extension behind code: browsers want it in front of everything, the host's text too");
  }

  // What the user's text does to names that the hosts put around it. `before_` may be a type.
  void declaration(std::string_view name) {
    if (before_ == "." || before_ == "return" || before_ == "else" || macros_.contains(name)) return;
    const bool calls = next_is("(");
    const bool variable = depth_ == 0 && (next_is(";") || next_is("=") || next_is(",") || next_is("["));
    const std::string quoted = "'" + std::string(name) + "'";
    if (calls && name == "mainImage" && !is_usual_image())
      own_host(
          "mainImage() has to be `void mainImage(out vec4, in vec2)`: shadertoy.com refuses other forms");
    if (name == "out" && before_ == "in") add("webgl2", "`in out`: browsers want `inout`");
    if (calls && name == "main" && before_ == "void" && audience_.site())
      own_host("main() is shadertoy.com's own, which refuses another one");
    if (calls && is_site_entry(name) && audience_.extension())
      add("portability", quoted + " is called on shadertoy.com, not in the VS Code extension");
    if (variable && (among(site_uniforms, name) || is_global_of_site(pass_.kind, name)) && audience_.site())
      own_host(quoted + " is there already on shadertoy.com, which refuses to declare it again");
    if ((variable && among(vscode_globals, name)) || (calls && name == "saturate" && depth_ == 0))
      taken_by_extension(name);
  }

  // In a project of shadertoy.com's it is an error, in one of the extension's it stops only who pastes it.
  void own_host(const std::string& text) {
    add(host_rules(project_).owns_names ? "webgl2" : "portability", text);
  }

  void taken_by_extension(std::string_view name) {
    if (audience_.extension())
      add("portability",
          "'" + std::string(name) + "' is there already in the VS Code extension, which refuses it again");
  }

  bool next_is(std::string_view text) const {
    return at_ + 1 < tokens_.size() && !tokens_[at_ + 1].preprocessor && tokens_[at_ + 1].is(text);
  }

  // Whether the function whose name is at at_ has the qualifiers that its prototype on shadertoy.com has.
  // What macros stand for is not known here.
  bool is_usual_image() const {
    if (before_ == "vec4" || before_ == "vec3" || before_ == "float") return false;
    std::size_t at = at_ + 2;
    const auto parameter = [&](std::string_view wanted, std::string_view type) {
      bool has_wanted = false;
      for (; at < tokens_.size() && !tokens_[at].is(",") && !tokens_[at].is(")"); ++at) {
        const Token& token = tokens_[at];
        if (token.is("inout") || token.is("const") || (token.is("out") && wanted != "out")) return false;
        has_wanted |= token.is(wanted);
        if (token.is(type) && wanted == "out" && !has_wanted) return false;
      }
      ++at;
      return true;
    };
    return parameter("out", "vec4") && parameter("in", "vec2");
  }

  // Names that a macro takes: `#define NAME`.
  void macro(std::string_view name) {
    const bool guarded =
        std::adjacent_find(tokens_.begin(), tokens_.end(), [&](const Token& a, const Token& b) {
          return a.is("ifndef") && b.is(name);
        }) != tokens_.end();
    if (name == "saturate" && !guarded) taken_by_extension(name);
    if (name == "fragCoord" && audience_.extension())
      add("portability", "a macro 'fragCoord' breaks the VS Code extension's main()");
  }

  // The number of tokens behind the # that at_ is at.
  std::size_t length_of_directive() const {
    std::size_t end = at_ + 1;
    while (end < tokens_.size() && tokens_[end].preprocessor && !(tokens_[end].first && tokens_[end].is("#")))
      ++end;
    return end - at_ - 1;
  }

  // A compiler tells what lacks its #endif at the end of the text; here it is told where it opens.
  void group() {
    const std::string_view word = at_ + 1 < tokens_.size() ? tokens_[at_ + 1].text : "";
    if (word == "if" || word == "ifdef" || word == "ifndef") open_.push_back(at_);
    if (word == "endif" && !open_.empty()) open_.pop_back();
  }

  void dropped_directive() {
    const std::size_t length = length_of_directive();
    if (length == 0) return;
    const Token& word = tokens_[at_ + 1];
    const bool alone = (word.is("else") || word.is("endif")) && length > 1;
    const bool named = (word.is("ifdef") || word.is("ifndef")) && length > 2;
    const std::string name = "#" + std::string(word.text);
    if (alone || named) add("webgl2", "browsers refuse what stands behind " + name);
    if (word.is("pragma") && length > 1 && tokens_[at_ + 2].is("STDGL"))
      add("webgl2", "#pragma STDGL invariant(all) is not for fragments: browsers refuse it");
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
  std::size_t first_line_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  Audience audience_;
  std::string_view before_;
  int depth_ = 0;  // of braces and parentheses
  bool in_define_ = false;
  std::vector<std::size_t> open_;  // groups of #if
  std::vector<bool> has_code_;     // by line, from 1
  std::set<std::string_view> macros_;
  std::set<std::string> told_;
  std::vector<Finding> findings_;
};

// Inputs that the extension has not.
std::vector<Finding> inputs_of_one_host(const Project& project, const Pass& pass) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < pass.inputs.size(); ++i)
    if (!info(pass.inputs[i].wanted()).in_extension)
      findings.push_back(make_finding(project, pass, {}, "portability",
                                      "iChannel" + std::to_string(i) + " is a " +
                                          std::string(info(pass.inputs[i].wanted()).name) +
                                          ", which the VS Code extension has not"));
  return findings;
}

// Uniforms that the shader declares and neither host has.
std::vector<Finding> uniforms_of_others(const Project& project, const Pass& pass) {
  std::vector<Finding> findings;
  for (const OtherUniform& uniform : pass.other_uniforms)
    findings.push_back(make_finding(project, pass, uniform.at, "portability",
                                    uniform.set ? "'" + uniform.name +
                                                      "' is set here as another host sets it, and not on "
                                                      "shadertoy.com"
                                                : words_for_unset(uniform)));
  return findings;
}

// Whether a line, which is empty, stands in code that the preprocessor skips.
bool is_skipped(const Project& project, const Pass& pass, SourceLine at) {
  constexpr std::string_view mark = "shadertwin_mark";
  const std::vector<SourceLine>& lines = pass.source.lines;
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const SourceLine& line) {
    return line.file == at.file && line.line == at.line;
  });
  if (found == lines.end()) return false;
  PassSource marked = pass.source;
  const std::size_t begin = begin_of_line(marked.written, static_cast<std::size_t>(found - lines.begin()));
  marked.body = marked.written.insert(begin, mark);
  resolve_macros(project, marked, ShaderStage::fragment);
  return marked.body.find(mark) == std::string::npos;
}

// #version, which both hosts have put in front of all by then: the site refuses another one, the extension
// all but the very first line.
std::vector<Finding> versions(const Project& project) {
  const bool site = project.dialect == Dialect::shadertoy;
  std::vector<Finding> findings;
  for (const SourceLine& at : project.versions) {
    const bool skipped = std::any_of(project.passes.begin(), project.passes.end(),
                                     [&](const Pass& pass) { return is_skipped(project, pass, at); });
    if (skipped) continue;
    findings.push_back(make_finding(
        project, project.passes.back(), at, site || at.line > 1 ? "webgl2" : "portability",
        site || at.line == 1 ? "#version is shadertoy.com's own, which refuses another one"
                             : "the VS Code extension refuses a #version behind the first line"));
  }
  return findings;
}

}  // namespace

std::vector<Finding> text_rules(const Project& project) {
  std::vector<Finding> findings = versions(project);
  const auto append = [&](std::vector<Finding> more) {
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  };
  for (const Pass& pass : project.passes) {
    append(TextRules(project, pass, pass.source.written).findings());
    const std::string written = project.common + pass.code;
    const auto common =
        static_cast<std::size_t>(std::count(project.common.begin(), project.common.end(), '\n'));
    const std::size_t before = pass.source.lines.size() - own_lines(pass);
    if (before >= common) append(TextRules(project, pass, written, before - common).findings_as_written());
    append(inputs_of_one_host(project, pass));
    append(uniforms_of_others(project, pass));
  }
  return findings;
}

}  // namespace shadertwin::check
