// Which values a compiler may find to be zero before the shader runs, also where the text names no constant:
// by what is assigned to variables and passed to functions. Mesa's llvmpipe makes x / 0.0 anything then, and
// 0.0 / x zero.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin {

class KnownZeros {
 public:
  explicit KnownZeros(const SyntaxTree& tree);

  // Whether some component of the value may be a zero that is known: of a variable, by what the text assigned
  // last, or if nothing but what is known is ever assigned. What nothing assigned is zero. A parameter counts
  // as known to be zero if some call passes one: functions are compiled into their callers.
  bool may_be_zero(const glslang::TIntermTyped& node);

 private:
  enum class Question { known, zero };
  using Values = std::vector<const glslang::TIntermTyped*>;
  class Collector;
  struct Assignment {
    const glslang::TIntermTyped* value;  // null: something that only the running shader knows
    int time;                            // counts assignments and uses, in the order of the text
    bool is_whole;                       // not of a component or an element
    std::optional<bool> is_zero = {};
  };

  bool holds(Question question, const glslang::TIntermTyped& node);
  bool any(Question question, const Values& values);
  bool all_known(const Values& values);
  bool of_variable(Question question, const glslang::TIntermSymbol& symbol);
  bool is_given(Question question, const Assignment& assignment);
  bool was_zero(const glslang::TIntermSymbol& symbol);
  bool stays_positive(const glslang::TIntermTyped& place);
  bool of_call(Question question, const glslang::TIntermAggregate& call);

  std::map<long long, std::vector<Assignment>> assigned_;  // to variables
  std::map<const glslang::TIntermSymbol*, int> uses_;      // of variables, and when
  std::map<long long, Values> passed_;                     // to parameters
  std::map<long long, bool> passed_zero_;
  std::set<long long> inputs_;              // parameters that get their first value so
  std::map<std::string, Values> returned_;  // by functions
  std::map<std::pair<long long, Question>, bool> answers_;
  std::set<std::pair<std::string, Question>> asked_;  // of functions, while their results are looked at
};

}  // namespace shadertwin
