#include "host/language/macro_expander.h"

#include <algorithm>

namespace shadertwin {

namespace {

using Kind = PreprocessingToken::Kind;

// The tokens of an argument.
class ArgumentReader : public TokenSource {
 public:
  explicit ArgumentReader(const std::vector<PreprocessingToken>& tokens) : tokens_(tokens) {}
  PreprocessingToken next() override { return at_ < tokens_.size() ? tokens_[at_++] : PreprocessingToken(); }

 private:
  const std::vector<PreprocessingToken>& tokens_;
  std::size_t at_ = 0;
};

std::string macro_limit(std::string_view name) {
  return "macro " + quoted(name) + " makes more than " + std::to_string(MacroExpander::held_limit) +
         " tokens at once";
}

}  // namespace

bool Macro::same_as(const Macro& other) const {
  return has_parameters == other.has_parameters && parameters == other.parameters &&
         std::equal(body.begin(), body.end(), other.body.begin(), other.body.end(),
                    [](const PreprocessingToken& a, const PreprocessingToken& b) {
                      return a.text == b.text && a.space_before == b.space_before;
                    });
}

void Macro::set_body(std::vector<PreprocessingToken> tokens) {
  std::unordered_map<std::string_view, int> numbers;
  for (const std::string_view parameter : parameters)
    numbers.emplace(parameter, static_cast<int>(numbers.size()));
  body = std::move(tokens);
  for (const PreprocessingToken& token : body) {
    const auto parameter = numbers.find(token.text);
    parameter_of.push_back(parameter == numbers.end() ? -1 : parameter->second);
  }
  if (!body.empty()) body.front().space_before = false;
}

MacroExpander::MacroExpander(TokenSource& source, const MacroTable& macros, PreprocessingState& state,
                             bool with_defined, int depth_left)
    : source_(source), macros_(macros), state_(state), with_defined_(with_defined), depth_left_(depth_left) {}

// What is left unread, as behind an error in an #if, is over.
MacroExpander::~MacroExpander() {
  reading_arguments_ = false;
  while (!expansions_.empty()) leave_expansion();
}

PreprocessingToken MacroExpander::next() {
  while (true) {
    PreprocessingToken token = get();
    if (!token.is(Kind::identifier)) return token;
    // A browser does not take a `defined` that a macro made for an operator.
    if (with_defined_ && token.text == "defined") return expansions_.empty() ? replace_defined() : token;
    if (token.never_expands) return token;
    const auto found = macros_.find(token.text);
    if (found == macros_.end()) return token;
    const std::shared_ptr<Macro> macro = found->second;
    if (macro->disabled) {
      token.never_expands = true;
      return token;
    }
    // Counted before the look ahead, which may read an #undef of it.
    ++macro->invocations;
    if (macro->has_parameters && !parenthesis_follows()) {
      --macro->invocations;
      return token;
    }
    expand(macro, token);
  }
}

PreprocessingToken MacroExpander::get() {
  if (put_back_) {
    const PreprocessingToken token = *put_back_;
    put_back_.reset();
    return token;
  }
  while (!expansions_.empty() && expansions_.back().at == expansions_.back().tokens.size()) leave_expansion();
  if (state_.exhausted()) return {};
  if (expansions_.empty()) return source_.next();
  Expansion& expansion = expansions_.back();
  return expansion.tokens[expansion.at++];
}

void MacroExpander::put_back(const PreprocessingToken& token) {
  if (expansions_.empty())
    put_back_ = token;
  else if (!token.is(Kind::end))
    --expansions_.back().at;
}

bool MacroExpander::parenthesis_follows() {
  const PreprocessingToken token = get();
  put_back(token);
  return token.is('(');
}

void MacroExpander::leave_expansion() {
  Expansion& expansion = expansions_.back();
  held_ -= expansion.tokens.size();
  --expansion.macro->invocations;
  if (reading_arguments_)
    left_.push_back(std::move(expansion.macro));
  else
    expansion.macro->disabled = false;
  expansions_.pop_back();
}

// `defined NAME` and `defined(NAME)` as 1 or 0.
PreprocessingToken MacroExpander::replace_defined() {
  PreprocessingToken token = get();
  const bool parenthesis = token.is('(');
  if (parenthesis) token = get();
  if (!token.is(Kind::identifier)) {
    state_.error(token.line, "'defined' needs a macro's name instead of " + quoted(token));
    return token;
  }
  PreprocessingToken result = token;
  result.kind = Kind::integer;
  result.text = macros_.contains(token.text) ? "1" : "0";
  if (!parenthesis) return result;
  token = get();
  if (token.is(')')) return result;
  state_.error(token.line, "')' is missing behind 'defined', before " + quoted(token));
  return token;
}

void MacroExpander::expand(const std::shared_ptr<Macro>& macro, const PreprocessingToken& name) {
  Expansion expansion;
  PreprocessingToken place = name;
  if (macro->has_parameters) {
    std::vector<Argument> arguments;
    if (!collect_arguments(*macro, name, arguments, place)) {
      --macro->invocations;
      return;
    }
    expansion.tokens = substitute(*macro, arguments);
  } else {
    expansion.tokens = replacement(*macro, name);
  }
  for (PreprocessingToken& token : expansion.tokens) {
    token.line = place.line;
    token.numbered_line = place.numbered_line;
    token.file = place.file;
  }
  if (!expansion.tokens.empty()) expansion.tokens.front().space_before = name.space_before;
  state_.spend(static_cast<std::int64_t>(expansion.tokens.size()) + 1, place.line);
  held_ += expansion.tokens.size();
  macro->disabled = true;
  expansion.macro = macro;
  expansions_.push_back(std::move(expansion));
}

std::vector<PreprocessingToken> MacroExpander::replacement(const Macro& macro,
                                                           const PreprocessingToken& name) const {
  std::vector<PreprocessingToken> tokens = macro.body;
  if (macro.origin == Macro::Origin::line || macro.origin == Macro::Origin::file) {
    const int value = macro.origin == Macro::Origin::line ? name.numbered_line : name.file;
    tokens.front().text = state_.intern(std::to_string(value));
  }
  return tokens;
}

std::vector<PreprocessingToken> MacroExpander::substitute(const Macro& macro,
                                                          const std::vector<Argument>& arguments) {
  std::vector<PreprocessingToken> tokens;
  for (std::size_t i = 0; i < macro.body.size(); ++i) {
    if (!tokens.empty() && tokens.size() + held_ > held_limit) {
      state_.error(tokens.back().line, macro_limit(tokens.back().text));
      return tokens;
    }
    if (macro.parameter_of[i] < 0) {
      tokens.push_back(macro.body[i]);
      continue;
    }
    const Argument& argument = arguments[static_cast<std::size_t>(macro.parameter_of[i])];
    if (argument.empty()) continue;
    const std::size_t first = tokens.size();
    tokens.insert(tokens.end(), argument.begin(), argument.end());
    tokens[first].space_before = macro.body[i].space_before;
  }
  return tokens;
}

// Reads what stands in an invocation's parentheses, and expands it. close: the closing parenthesis.
bool MacroExpander::collect_arguments(const Macro& macro, const PreprocessingToken& name,
                                      std::vector<Argument>& arguments, PreprocessingToken& close) {
  get();  // the opening parenthesis
  reading_arguments_ = true;
  arguments.emplace_back();
  int depth = 1;
  bool complete = true;
  while (depth > 0) {
    PreprocessingToken token = get();
    if (token.is(Kind::end)) {
      if (!state_.exhausted())
        state_.error(name.line, "the arguments of macro " + quoted(name) + " have no end: ')' is missing");
      put_back(token);
      complete = false;
      break;
    }
    state_.spend(1, token.line);  // nested invocations are read again at every level
    if (token.is('(')) ++depth;
    if (token.is(')') && --depth == 0) {
      close = token;
      break;
    }
    if (token.is(',') && depth == 1) {
      arguments.emplace_back();
      continue;
    }
    if (arguments.back().empty()) token.space_before = false;
    arguments.back().push_back(token);
  }
  if (macro.parameters.empty() && arguments.size() == 1 && arguments.front().empty()) arguments.clear();
  if (complete && arguments.size() != macro.parameters.size()) {
    const bool few = arguments.size() < macro.parameters.size();
    state_.error(name.line, "macro " + quoted(name) + " has too " + (few ? "few" : "many") +
                                " arguments: " + std::to_string(arguments.size()) + " instead of " +
                                std::to_string(macro.parameters.size()));
    complete = false;
  }
  complete = complete && expand_arguments(arguments, close);
  reading_arguments_ = false;
  for (const std::shared_ptr<Macro>& left : left_) left->disabled = false;
  left_.clear();
  return complete;
}

bool MacroExpander::expand_arguments(std::vector<Argument>& arguments, const PreprocessingToken& close) {
  std::size_t count = 0;
  for (Argument& argument : arguments) {
    if (depth_left_ < 1) {
      state_.error(close.line, "macros are invoked in arguments of macros more than " +
                                   std::to_string(depth_limit) + " times within each other");
      return false;
    }
    ArgumentReader reader(argument);
    MacroExpander expander(reader, macros_, state_, with_defined_, depth_left_ - 1);
    Argument expanded;
    for (PreprocessingToken token = expander.next(); !token.is(Kind::end); token = expander.next()) {
      expanded.push_back(token);
      if (++count + held_ > held_limit) {
        state_.error(token.line, macro_limit(token.text));
        return false;
      }
    }
    if (!state_.spend(static_cast<std::int64_t>(expanded.size()), close.line)) return false;
    argument = std::move(expanded);
  }
  return true;
}

}  // namespace shadertwin
