// Macros and their expansion, in the order in which ANGLE does it: token by token, while directives between
// the tokens of an invocation are obeyed as they come.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "host/language/preprocessing_token.h"

namespace shadertwin {

struct Macro {
  enum class Origin {
    text,
    host,      // PreprocessOptions::predefined
    language,  // can't be defined anew
    line,      // __LINE__
    file,      // __FILE__
  };
  Origin origin = Origin::text;
  bool has_parameters = false;  // function-like; there may be none in the parentheses
  std::vector<std::string_view> parameters;
  std::vector<PreprocessingToken> body;
  std::vector<int> parameter_of;  // for each token of the body: the parameter that it is, or -1
  bool disabled = false;          // being expanded
  int invocations = 0;            // that are not done

  bool predefined() const { return origin != Origin::text && origin != Origin::host; }
  bool same_as(const Macro& other) const;
  // The parameters are known by then.
  void set_body(std::vector<PreprocessingToken> tokens);
};

// By name. Macros are shared with the expansions that still read them.
using MacroTable = std::unordered_map<std::string_view, std::shared_ptr<Macro>>;

class MacroExpander : public TokenSource {
 public:
  // The limits of ANGLE: invocations within arguments of invocations, and tokens that one argument and the
  // expansions around it, or one expansion, may hold.
  static constexpr int depth_limit = 1000;
  static constexpr std::size_t held_limit = 10000;

  // with_defined: whether `defined` is an operator, as in #if.
  MacroExpander(TokenSource& source, const MacroTable& macros, PreprocessingState& state, bool with_defined,
                int depth_left = depth_limit);
  ~MacroExpander() override;

  PreprocessingToken next() override;

 private:
  using Argument = std::vector<PreprocessingToken>;

  struct Expansion {
    std::shared_ptr<Macro> macro;
    std::vector<PreprocessingToken> tokens;
    std::size_t at = 0;
  };

  PreprocessingToken get();
  void put_back(const PreprocessingToken& token);
  bool parenthesis_follows();
  void leave_expansion();
  PreprocessingToken replace_defined();
  void expand(const std::shared_ptr<Macro>& macro, const PreprocessingToken& name);
  std::vector<PreprocessingToken> replacement(const Macro& macro, const PreprocessingToken& name) const;
  std::vector<PreprocessingToken> substitute(const Macro& macro, const std::vector<Argument>& arguments);
  bool collect_arguments(const Macro& macro, const PreprocessingToken& name, std::vector<Argument>& arguments,
                         PreprocessingToken& close);
  bool expand_arguments(std::vector<Argument>& arguments, const PreprocessingToken& close);

  TokenSource& source_;
  const MacroTable& macros_;
  PreprocessingState& state_;
  const bool with_defined_;
  const int depth_left_;
  std::vector<Expansion> expansions_;
  std::size_t held_ = 0;  // tokens in expansions_
  std::optional<PreprocessingToken> put_back_;
  // While an invocation's arguments are read, macros that are left stay disabled: else an argument could
  // expand what it came from, without end.
  bool reading_arguments_ = false;
  std::vector<std::shared_ptr<Macro>> left_;
};

}  // namespace shadertwin
