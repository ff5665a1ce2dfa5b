#include "host/language/directive_parser.h"

#include <unordered_set>

#include "host/language/directive_expression.h"

namespace shadertwin {

namespace {

using Kind = PreprocessingToken::Kind;

bool is_reserved(std::string_view name) {
  return name == "defined" || name.starts_with("GL_");
}

bool is_conditional(std::string_view directive) {
  return directive == "if" || directive == "ifdef" || directive == "ifndef" || directive == "else" ||
         directive == "elif" || directive == "endif";
}

// Tokens as a compiler reads them back.
std::string joined(const std::vector<PreprocessingToken>& tokens) {
  std::string result;
  for (const PreprocessingToken& token : tokens) {
    if (token.space_before && !result.empty()) result += ' ';
    result += token.text;
  }
  return result;
}

}  // namespace

DirectiveParser::DirectiveParser(SourceReader& source, PreprocessingState& state,
                                 const PreprocessOptions& options)
    : source_(source), state_(state), options_(options) {
  predefine("GL_ES", "1", Macro::Origin::language);
  predefine("GL_FRAGMENT_PRECISION_HIGH", "1", Macro::Origin::language);
  predefine("__VERSION__", "300", Macro::Origin::language);
  predefine("__LINE__", "0", Macro::Origin::line);
  predefine("__FILE__", "0", Macro::Origin::file);
  for (const auto& [name, replacement, parameters] : options.predefined)
    predefine(name, replacement, Macro::Origin::host, parameters);
}

void DirectiveParser::predefine(std::string_view name, std::string_view replacement, Macro::Origin origin,
                                const std::vector<std::string>& parameters) {
  auto macro = std::make_shared<Macro>();
  macro->origin = origin;
  macro->has_parameters = !parameters.empty();
  macro->parameters.assign(parameters.begin(), parameters.end());
  macro->set_body(tokens_of_line(replacement));
  macros_[name] = std::move(macro);
}

bool DirectiveParser::skipping() const {
  return !conditions_.empty() && (conditions_.back().skipping || conditions_.back().within_skipped);
}

PreprocessingToken DirectiveParser::next() {
  while (true) {
    token_ = source_.next();
    if (token_.starts_line && token_.text == "#") {
      parse_directive();
      anything_before_ = true;
    } else if (!token_.ends_directive() && !skipping()) {
      code_before_ = true;
    }
    if (token_.is(Kind::end)) {
      if (!conditions_.empty() && !state_.exhausted())
        state_.error(conditions_.back().line,
                     "#" + std::string(conditions_.back().directive) + " has no #endif");
      conditions_.clear();
      return token_;
    }
    if (!skipping() && !token_.is(Kind::line_end)) break;
  }
  anything_before_ = true;
  return token_;
}

// From the # to the line's end.
void DirectiveParser::parse_directive() {
  advance();
  if (token_.ends_directive()) return;
  const std::string_view directive = token_.is(Kind::identifier) ? token_.text : "";
  if (skipping() && !is_conditional(directive)) {
    // Nothing in a skipped group is looked at but what ends it.
  } else if (directive == "define") {
    parse_define();
  } else if (directive == "undef") {
    parse_undef();
  } else if (directive == "if" || directive == "ifdef" || directive == "ifndef") {
    parse_if(directive);
  } else if (directive == "else") {
    parse_else();
  } else if (directive == "elif") {
    parse_elif();
  } else if (directive == "endif") {
    parse_endif();
  } else if (directive == "error") {
    parse_error();
  } else if (directive == "pragma") {
    parse_pragma();
  } else if (directive == "extension") {
    parse_extension();
  } else if (directive == "version") {
    parse_version();
  } else if (directive == "line") {
    parse_line();
  } else {
    error("there is no directive #" + std::string(directive.empty() ? "" : directive) +
          (directive.empty() ? " that begins with " + quoted(token_) : ""));
  }
  while (!token_.ends_directive()) advance();
}

void DirectiveParser::expect_end(std::string_view directive) {
  if (!token_.ends_directive()) error(quoted(token_) + " is too much behind #" + std::string(directive));
}

void DirectiveParser::parse_define() {
  advance();
  const PreprocessingToken name = token_;
  if (!name.is(Kind::identifier)) return error("#define needs a name instead of " + quoted(name));
  const auto known = macros_.find(name.text);
  if (known != macros_.end() && known->second->predefined())
    return error("the macro " + quoted(name) + " is the language's own and can't be defined anew");
  if (is_reserved(name.text)) return error("the name " + quoted(name) + " is reserved and can't be defined");
  auto macro = std::make_shared<Macro>();
  advance();
  if (token_.is('(') && !token_.space_before && !parse_parameters(*macro)) return;
  std::vector<PreprocessingToken> body;
  for (; !token_.ends_directive(); advance()) body.push_back(token_);
  macro->set_body(std::move(body));
  if (known != macros_.end() && known->second->origin == Macro::Origin::text) {
    if (!macro->same_as(*known->second))
      error("the macro " + quoted(name) + " is defined already, and differently");
    return;
  }
  macros_[name.text] = std::move(macro);
}

// From the opening parenthesis to what follows the closing one. As in browsers, a comma may end the list.
bool DirectiveParser::parse_parameters(Macro& macro) {
  macro.has_parameters = true;
  std::unordered_set<std::string_view> names;
  do {
    advance();
    if (!token_.is(Kind::identifier)) break;
    if (!names.insert(token_.text).second) {
      error("the parameter " + quoted(token_) + " is there twice");
      return false;
    }
    macro.parameters.push_back(token_.text);
    advance();
  } while (token_.is(','));
  if (!token_.is(')')) {
    error("a macro's parameters are names with commas between, and ')' ends them, instead of " +
          quoted(token_));
    return false;
  }
  advance();
  return true;
}

void DirectiveParser::parse_undef() {
  advance();
  if (!token_.is(Kind::identifier)) return error("#undef needs a name instead of " + quoted(token_));
  const auto known = macros_.find(token_.text);
  if (known != macros_.end()) {
    if (known->second->predefined())
      error("the macro " + quoted(token_) + " is the language's own and can't be undefined");
    else if (known->second->invocations > 0)
      error("the macro " + quoted(token_) + " is undefined within its own invocation");
    else
      macros_.erase(known);
  }
  advance();
  expect_end("undef");
}

void DirectiveParser::parse_if(std::string_view directive) {
  Condition condition;
  condition.directive = directive;
  condition.line = token_.line;
  if (skipping()) {
    condition.within_skipped = true;
  } else {
    condition.taken = directive == "if" ? read_expression() : read_whether_defined(directive);
    condition.skipping = !condition.taken;
  }
  conditions_.push_back(condition);
}

void DirectiveParser::parse_else() {
  if (conditions_.empty()) return error("#else has no #if");
  Condition& condition = conditions_.back();
  if (condition.within_skipped) return;
  if (condition.has_else) return error("#else follows another #else");
  condition.has_else = true;
  condition.skipping = condition.taken;
  condition.taken = true;
  advance();
  expect_end("else");
}

void DirectiveParser::parse_elif() {
  if (conditions_.empty()) return error("#elif has no #if");
  if (conditions_.back().within_skipped) return;
  if (conditions_.back().has_else) return error("#elif follows #else");
  if (conditions_.back().taken) {
    conditions_.back().skipping = true;  // whatever its expression is
    return;
  }
  const bool taken = read_expression();
  conditions_.back().skipping = !taken;
  conditions_.back().taken = taken;
}

void DirectiveParser::parse_endif() {
  if (conditions_.empty()) return error("#endif has no #if");
  conditions_.pop_back();
  advance();
  expect_end("endif");
}

// Reads from the text itself, not from its code: as in browsers, a macro's arguments may go on behind the
// line.
bool DirectiveParser::read_expression() {
  MacroExpander expander(source_, macros_, state_, true);
  token_ = expander.next();
  const DirectiveExpression expression =
      evaluate(expander, token_, state_, {.name_error = " is no macro here, and #if takes no other name"});
  if (expression.valid) expect_end("if, where its expression has ended");
  return expression.value != 0;
}

bool DirectiveParser::read_whether_defined(std::string_view directive) {
  advance();
  if (!token_.is(Kind::identifier)) {
    error("#" + std::string(directive) + " needs a name instead of " + quoted(token_));
    return directive == "ifndef";
  }
  const bool is_defined = macros_.contains(token_.text);
  advance();
  expect_end(directive);
  return is_defined == (directive == "ifdef");
}

void DirectiveParser::parse_error() {
  const int line = token_.line;
  std::vector<PreprocessingToken> words;
  for (advance(); !token_.ends_directive(); advance()) words.push_back(token_);
  std::string message = joined(words);
  for (char& c : message)
    if (c < ' ' || c > '~') c = '?';
  state_.error(line, "#error" + (message.empty() ? "" : " " + message));
}

// `#pragma [STDGL] name[(value)]`; any other form is ignored.
void DirectiveParser::parse_pragma() {
  const int line = token_.line;
  std::vector<PreprocessingToken> words;
  for (advance(); !token_.ends_directive(); advance()) words.push_back(token_);
  const bool stdgl = !words.empty() && words[0].text == "STDGL";
  const std::size_t at = stdgl ? 1 : 0;
  const std::size_t count = words.size() - at;
  const bool has_value = count == 4 && words[at + 1].is('(') && words[at + 3].is(')');
  if ((count == 1 || has_value) && words[at].is(Kind::identifier)) {
    const std::string_view name = words[at].text;
    const std::string_view value = has_value ? words[at + 2].text : "";
    if (stdgl && name == "invariant" && value == "all")
      state_.error(line, "#pragma STDGL invariant(all) is not for fragment shaders");
    if (!stdgl && (name == "optimize" || name == "debug") && value != "on" && value != "off")
      state_.error(line, "#pragma " + std::string(name) + " needs (on) or (off)");
  }
  state_.result.directives.push_back({"#pragma" + (words.empty() ? "" : " " + joined(words)), line, true});
}

// `#extension name : behaviour`
void DirectiveParser::parse_extension() {
  const int line = token_.line;
  std::vector<PreprocessingToken> words;
  for (advance(); !token_.ends_directive(); advance()) words.push_back(token_);
  if (words.size() != 3 || !words[0].is(Kind::identifier) || !words[1].is(':') ||
      !words[2].is(Kind::identifier))
    return state_.error(line, "an extension's line is: #extension name : behaviour");
  if (options_.es100) return;
  if (options_.behind_head || code_before_)
    return state_.error(line, options_.behind_head
                                  ? "#extension has to stand before the first code, which is the host's"
                                  : "#extension has to stand before the first code");
  const std::string_view name = words[0].text;
  const std::string_view behaviour = words[2].text;
  if (behaviour != "require" && behaviour != "enable" && behaviour != "warn" && behaviour != "disable")
    return state_.error(line, quoted(words[2]) + " is no behaviour of an extension");
  if (name == "all" && (behaviour == "require" || behaviour == "enable"))
    return state_.error(line, "#extension all can't be '" + std::string(behaviour) + "'");
  // WebGL2 has what its extensions add to the language in it, or not at all.
  if (behaviour == "require")
    return state_.error(line, "the extension " + quoted(words[0]) + " is not supported");
  state_.result.directives.push_back(
      {"#extension " + std::string(name) + " : " + std::string(behaviour), line, true});
}

void DirectiveParser::parse_version() {
  const int line = token_.line;
  if (options_.behind_head || anything_before_)
    return state_.error(line, options_.behind_head ? "#version has to be the first line, which is the host's"
                                                   : "#version has to stand before anything but comments");
  std::vector<PreprocessingToken> words;
  for (advance(); !token_.ends_directive(); advance()) words.push_back(token_);
  const bool form = words.size() == 2 && words[0].is(Kind::integer) && words[1].text == "es";
  std::string_view number = form ? words[0].text : "";
  while (number.ends_with('u') || number.ends_with('U')) number.remove_suffix(1);
  if (number != "300") return state_.error(line, "the version has to be: #version 300 es");
  if (token_.line > 1) state_.error(token_.line, "#version has to be on the first line");
}

void DirectiveParser::parse_line() {
  MacroExpander expander(source_, macros_, state_, false);
  token_ = expander.next();
  ExpressionRules rules{.is_signed = true, .name_error = " is no number of a line"};
  const DirectiveExpression line = evaluate(expander, token_, state_, rules);
  if (!line.valid) return;
  DirectiveExpression file;
  const bool has_file = !token_.ends_directive();
  if (has_file) {
    rules.name_error = " is no number of a file";
    file = evaluate(expander, token_, state_, rules);
    if (!file.valid) return;
  }
  if (!token_.ends_directive()) return expect_end("line");
  source_.set_line(line.value);
  if (has_file) source_.set_file(file.value);
}

}  // namespace shadertwin
