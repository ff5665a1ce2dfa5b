#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "host/language/tokens.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

using Kind = Token::Kind;

struct Definition {
  bool has_parameters = false;
  std::vector<std::string_view> body;  // identifiers and punctuation
  int line = 0;
};

// The text before its macros are resolved. Of a macro that is defined several times, the last one counts.
class MacroReader {
 public:
  explicit MacroReader(std::string_view text) : tokens_(tokenize(text)) {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
      if (tokens_[i].first && tokens_[i].is("#") && tokens_[i + 1].is("define") &&
          tokens_[i + 2].preprocessor)
        define(i + 2);
  }

  // Lines and words of what is to be told, from 1.
  std::vector<std::pair<int, std::string>> read() {
    for (const auto& [name, macro] : macros_)
      if (opens_an_invocation(macro) && is_used(name))
        found_.emplace_back(macro.line, "macro '" + std::string(name) +
                                            "' opens an invocation that the text behind it closes: some "
                                            "preprocessors fail at that");
    for (const auto& [name, macro] : macros_)
      if (const int line = names_itself(name) ? line_as_argument(name) : 0; line > 0)
        found_.emplace_back(line,
                            "macro '" + std::string(name) +
                                "' names itself and is another one's argument: some preprocessors expand "
                                "it twice");
    find_directives_in_arguments();
    return std::move(found_);
  }

 private:
  // `at`: the token of the name.
  void define(std::size_t at) {
    Definition macro;
    macro.line = tokens_[at].line;
    std::size_t i = at + 1;
    const auto inside = [&] { return i < tokens_.size() && tokens_[i].preprocessor && !tokens_[i].first; };
    macro.has_parameters = inside() && tokens_[i].is("(") && !tokens_[i].space_before;
    if (macro.has_parameters)
      while (inside() && !tokens_[i++].is(")")) continue;
    for (; inside(); ++i) macro.body.push_back(tokens_[i].text);
    macros_[tokens_[at].text] = std::move(macro);
  }

  // `MACRO (` without its closing parenthesis.
  bool opens_an_invocation(const Definition& macro) const {
    std::vector<bool> open;  // whether each parenthesis is an invocation's
    for (std::size_t i = 0; i < macro.body.size(); ++i) {
      if (macro.body[i] == "(") open.push_back(i > 0 && takes_parameters(macro.body[i - 1]));
      if (macro.body[i] == ")" && !open.empty()) open.pop_back();
    }
    return std::find(open.begin(), open.end(), true) != open.end();
  }

  bool takes_parameters(std::string_view name) const {
    const auto macro = macros_.find(name);
    return macro != macros_.end() && macro->second.has_parameters;
  }

  bool is_used(std::string_view name) const {
    return std::any_of(tokens_.begin(), tokens_.end(),
                       [&](const Token& token) { return !token.preprocessor && token.is(name); });
  }

  bool names_itself(std::string_view name) const {
    std::set<std::string_view> seen;
    std::vector<std::string_view> open = {name};
    while (!open.empty()) {
      const std::string_view next = open.back();
      open.pop_back();
      const auto macro = macros_.find(next);
      if (macro == macros_.end()) continue;
      for (const std::string_view word : macro->second.body) {
        if (word == name) return true;
        if (seen.insert(word).second) open.push_back(word);
      }
    }
    return false;
  }

  void find_directives_in_arguments() {
    std::vector<std::string_view> open;  // the macro that each parenthesis belongs to, or nothing
    bool told = false;                   // of this invocation
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool directive = tokens_[i].first && tokens_[i].is("#");
      if (!directive && tokens_[i].preprocessor) continue;
      if (tokens_[i].is("("))
        open.push_back(i > 0 && !tokens_[i - 1].preprocessor && takes_parameters(tokens_[i - 1].text)
                           ? tokens_[i - 1].text
                           : "");
      if (tokens_[i].is(")") && !open.empty()) open.pop_back();
      const auto macro = std::find_if(open.begin(), open.end(), [](auto name) { return !name.empty(); });
      if (macro == open.end()) told = false;
      if (directive && macro != open.end() && !std::exchange(told, true))
        found_.emplace_back(tokens_[i].line, "a directive between the arguments of macro '" +
                                                 std::string(*macro) + "': some preprocessors refuse it");
    }
  }

  // Where the code has the macro within the parentheses of another one's invocation; 0: nowhere.
  int line_as_argument(std::string_view name) const {
    std::vector<bool> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].preprocessor) continue;
      if (tokens_[i].is("("))
        open.push_back(i > 0 && !tokens_[i - 1].is(name) && takes_parameters(tokens_[i - 1].text));
      if (tokens_[i].is(")") && !open.empty()) open.pop_back();
      if (tokens_[i].is(name) && std::find(open.begin(), open.end(), true) != open.end())
        return tokens_[i].line;
    }
    return 0;
  }

  std::vector<Token> tokens_;
  std::map<std::string_view, Definition> macros_;
  std::vector<std::pair<int, std::string>> found_;
};

}  // namespace

std::vector<Finding> macro_rules(const Project& project) {
  std::vector<Finding> findings;
  for (const Pass& pass : project.passes)
    for (const auto& [line, words] : MacroReader(pass.source.written).read())
      if (const auto index = static_cast<std::size_t>(line - 1); index < pass.source.lines.size())
        findings.push_back(make_finding(project, pass, pass.source.lines[index], "portability", words));
  return findings;
}

}  // namespace shadertwin::check
