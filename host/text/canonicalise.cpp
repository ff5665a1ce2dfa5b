#include "host/text/canonicalise.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "host/language/browser_names.h"
#include "host/language/edits.h"
#include "host/language/tokens.h"

namespace shadertwin {

namespace {

const std::set<std::string_view> parameter_qualifiers = {"const", "in",      "out",  "inout",
                                                         "lowp",  "mediump", "highp"};

bool is_precision(const Token& token) {
  return token.is("lowp") || token.is("mediump") || token.is("highp");
}

class Rewriter {
 public:
  Rewriter(std::string_view text, const std::vector<Overload>& open)
      : text_(text), tokens_(tokenize(text)), open_(open) {}

  std::string run() {
    find_declared();
    find_members();
    rename_variables();
    rename_open_builtins();
    rename_structures();
    rename_length_members();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (token.preprocessor) continue;  // #extension or #pragma
      if (token.kind == Token::Kind::identifier &&
          (later_words().contains(token.text) || renamed_.contains(token.text) ||
           token.text.starts_with("shadertwin_")))
        rename(i);
      if (token.kind == Token::Kind::identifier && token.text.starts_with("iCh")) fix_channel_struct(i);
      if (token.is("(") && opens_function(i)) name_parameters(i);
      if (token.is("precision")) drop_precision(i);
      if (is_precision(token)) drop(i);
      // The last label of a switch needs a statement that does something.
      if (token.is(":") && only_empty_follows(i)) edits_.push_back({token.end(), 0, " break;"});
    }
    return edited(text_, std::move(edits_));
  }

 private:
  bool is_word(std::size_t i) const { return tokens_[i].kind == Token::Kind::identifier; }

  // Whether a switch ends after the label, with no more than empty statements and blocks before.
  bool only_empty_follows(std::size_t label) const {
    int depth = 0;
    for (std::size_t i = label + 1; i < tokens_.size(); ++i) {
      if (tokens_[i].is("}") && depth-- == 0) return i > label + 1;
      if (tokens_[i].is("{"))
        ++depth;
      else if (!tokens_[i].is(";") && !tokens_[i].is("}"))
        return false;
    }
    return false;
  }

  // A name, a type before it, and it is no statement's keyword.
  bool opens_function(std::size_t paren) const {
    if (paren < 2 || tokens_[paren].preprocessor || !is_word(paren - 1)) return false;
    const Token& name = tokens_[paren - 1];
    const Token& before = tokens_[paren - 2];
    if (name.is("if") || name.is("for") || name.is("while") || name.is("switch")) return false;
    if (before.preprocessor || before.is("return") || before.is("else")) return false;
    return before.kind == Token::Kind::identifier || before.is("]");
  }

  void find_declared() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].is("(") && opens_function(i) && other_builtins().contains(tokens_[i - 1].text))
        renamed_.insert(tokens_[i - 1].text);
    }
  }

  // Where structures name their members.
  void find_members() {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      if (!tokens_[i].is("struct")) continue;
      std::size_t k = i + (tokens_[i + 1].is("{") ? 2 : 3);
      if (!tokens_[k - 1].is("{")) continue;
      int words = 0;  // of the declaration so far, but for precisions
      for (int brackets = 0; k < tokens_.size() && !tokens_[k].is("}"); ++k) {
        if (tokens_[k].is("[")) ++brackets;
        if (tokens_[k].is("]")) --brackets;
        if (tokens_[k].is(";")) words = 0;
        if (brackets == 0 && is_word(k) && !is_precision(tokens_[k]) && words++ > 0) members_.insert(k);
      }
    }
  }

  // Whether the token names a member of a structure, there or where it is used.
  bool is_member(std::size_t i) const { return members_.contains(i) || (i > 0 && tokens_[i - 1].is(".")); }

  void drop(std::size_t i) { edits_.push_back({tokens_[i].begin, tokens_[i].text.size(), ""}); }

  // `precision mediump float;`, but for types that the head gives none.
  void drop_precision(std::size_t i) {
    if (i + 3 >= tokens_.size() || !is_precision(tokens_[i + 1]) || !tokens_[i + 3].is(";")) return;
    const Token& type = tokens_[i + 2];
    const bool known = type.is("float") || type.is("int") || type.is("sampler2D") || type.is("sampler3D") ||
                       type.is("samplerCube");
    if (!known) return;
    drop(i);
    drop(i + 2);
    drop(i + 3);
  }

  void rename(std::size_t i) { edits_.push_back({tokens_[i].begin, 0, "shadertwin_"}); }

  // A global variable may have a built-in function's name: from there on, whatever is not called means it.
  void rename_variables() {
    std::set<std::string_view> names;
    int depth = 0;
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      const Token& next = tokens_[i + 1];
      if (token.is("{") || token.is("(")) ++depth;
      if (token.is("}") || token.is(")")) depth = std::max(depth - 1, 0);
      const bool is_builtin = builtins().contains(token.text) || other_builtins().contains(token.text);
      if (!is_word(i) || !is_builtin) continue;
      const Token& before = tokens_[i - 1];
      const bool declared = depth == 0 && !before.preprocessor &&
                            (is_word(i - 1) || before.is("]") || before.is(",")) &&
                            (next.is("=") || next.is(";") || next.is(",") || next.is("["));
      if (declared) names.insert(token.text);
      if (names.contains(token.text) && !next.is("(") && !is_member(i)) rename(i);
    }
  }

  // A structure may have a built-in function's name: to the end of its scope the name means it, called or
  // not.
  void rename_structures() {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      const std::string_view name = tokens_[i + 1].text;
      if (!tokens_[i].is("struct") || !tokens_[i + 2].is("{")) continue;
      if (!builtins().contains(name) && !other_builtins().contains(name)) continue;
      int depth = 0;
      for (std::size_t k = i + 1; k < tokens_.size() && depth >= 0; ++k) {
        if (tokens_[k].is("{")) ++depth;
        if (tokens_[k].is("}")) --depth;
        if (tokens_[k].is(name) && !is_member(k)) rename(k);
      }
    }
  }

  // `length` as a structure's member: glslang takes it for the size of an array.
  void rename_length_members() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i)
      if (tokens_[i].is("length") && is_member(i) && !tokens_[i + 1].is("(")) rename(i);
  }

  // The types of the parameters in the parentheses that open at `open`, each followed by a comma.
  std::string signature(std::size_t open) const {
    std::string types;
    bool wanted = true;
    for (std::size_t i = open + 1; i < tokens_.size() && !tokens_[i].is(")"); ++i) {
      if (tokens_[i].is(",")) wanted = true;
      if (!wanted || !is_word(i) || parameter_qualifiers.contains(tokens_[i].text)) continue;
      types += std::string(tokens_[i].text) + ",";
      wanted = false;
    }
    return types;
  }

  // Functions named as built-ins that browsers let a shader define again: they and the built-ins that they
  // don't hide become functions of one other name.
  void rename_open_builtins() {
    std::map<std::string_view, std::set<std::string>> own;
    std::map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!tokens_[i].is("(") || !opens_function(i)) continue;
      const std::string_view name = tokens_[i - 1].text;
      if (std::none_of(open_.begin(), open_.end(), [&](const Overload& o) { return o.name == name; }))
        continue;
      own[name].insert(signature(i));
      first.emplace(name, i - 2);
    }
    for (const auto& [name, place] : first) {
      edits_.push_back({tokens_[place].begin, 0, forwarders(name, own[name])});
      for (std::size_t i = place; i + 1 < tokens_.size(); ++i)
        if (tokens_[i].is(name) && tokens_[i + 1].is("(")) rename(i);
    }
  }

  std::string forwarders(std::string_view name, const std::set<std::string>& own) const {
    std::string text;
    for (const Overload& overload : open_) {
      if (overload.name != name) continue;
      std::string types, parameters, arguments;
      for (const std::string_view type : overload.parameters) {
        const std::string comma = types.empty() ? "" : ", ";
        const std::string parameter(1, static_cast<char>('a' + std::count(types.begin(), types.end(), ',')));
        types.append(type) += ',';
        parameters += comma + std::string(type) + " " + parameter;
        arguments += comma + parameter;
      }
      if (own.contains(types)) continue;
      text += std::string(overload.result) + " shadertwin_" + std::string(name) + "(" + parameters +
              ") { return " + std::string(name) + "(" + arguments + "); } ";
    }
    return text;
  }

  void fix_channel_struct(std::size_t i) {
    const std::string_view name = tokens_[i].text;
    if (name.size() != 4 || name[3] < '0' || name[3] > '3' || i + 2 >= tokens_.size() ||
        !tokens_[i + 1].is("."))
      return;
    const Token& member = tokens_[i + 2];
    const std::string channel(1, name[3]);
    std::string by;
    if (member.is("sampler")) by = "iChannel" + channel;
    if (member.is("size")) by = "iChannelResolution[" + channel + "]";
    if (member.is("time")) by = "iChannelTime[" + channel + "]";
    if (member.is("loaded")) by = "shadertwin_loaded_" + channel;
    if (!by.empty() && member.line == tokens_[i].line)
      edits_.push_back({tokens_[i].begin, member.end() - tokens_[i].begin, by});
  }

  // The parameters of a definition; a prototype may stay as it is.
  void name_parameters(std::size_t open) {
    std::size_t close = open;
    int depth = 0;
    for (; close < tokens_.size(); ++close) {
      if (tokens_[close].is("(")) ++depth;
      if (tokens_[close].is(")") && --depth == 0) break;
      if (tokens_[close].is("{") || tokens_[close].is(";")) return;
    }
    if (close + 1 >= tokens_.size() || !tokens_[close + 1].is("{")) return;
    std::size_t start = open + 1;
    depth = 0;
    for (std::size_t i = start; i <= close; ++i) {
      if (tokens_[i].is("[") || tokens_[i].is("(")) ++depth;
      if (tokens_[i].is("]") || (tokens_[i].is(")") && i < close)) --depth;
      if (i < close && (depth > 0 || !tokens_[i].is(","))) continue;
      name_parameter(start, i);
      start = i + 1;
    }
  }

  void name_parameter(std::size_t begin, std::size_t end) {
    while (begin < end && parameter_qualifiers.contains(tokens_[begin].text)) ++begin;
    if (begin >= end || !is_word(begin)) return;
    const bool unnamed = begin + 1 == end || (tokens_[begin + 1].is("[") && tokens_[end - 1].is("]"));
    if (unnamed && !tokens_[begin].is("void"))
      edits_.push_back({tokens_[end - 1].end(), 0, " shadertwin_unnamed_" + std::to_string(unnamed_++)});
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  const std::vector<Overload>& open_;  // built-ins that the shader may define again
  std::vector<Edit> edits_;
  std::set<std::string_view> renamed_;
  std::set<std::size_t> members_;
  int unnamed_ = 0;
};

}  // namespace

std::string canonicalise(std::string_view text, bool es100) {
  return Rewriter(text, es100 ? open_builtins_of_es100() : open_builtins()).run();
}

}  // namespace shadertwin
