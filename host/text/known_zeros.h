// Which values a compiler may find to be zero before the shader runs, also where the text names no constant:
// by what is assigned to variables and passed to functions. Mesa's llvmpipe makes x / y anything then.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin {

class KnownZeros {
 public:
  explicit KnownZeros(const SyntaxTree& tree);

  // Whether some component of the value may be a zero that is known. A parameter counts as known to be zero
  // if some call passes one: functions are compiled into their callers.
  bool may_be_zero(const glslang::TIntermTyped& node);

 private:
  enum class Question { known, zero };
  using Values = std::vector<const glslang::TIntermTyped*>;
  class Collector;

  bool holds(Question question, const glslang::TIntermTyped& node);
  bool any(Question question, const Values& values);
  bool all_known(const Values& values);
  bool of_variable(Question question, long long id);
  bool of_call(Question question, const glslang::TIntermAggregate& call);

  std::map<long long, Values> assigned_;  // to variables; null: something that only the running shader knows
  std::map<long long, Values> passed_;    // to parameters
  std::map<std::string, Values> returned_;  // by functions
  std::map<std::pair<long long, Question>, bool> answers_;
  std::set<std::pair<std::string, Question>> asked_;  // of functions, while their results are looked at
};

}  // namespace shadertwin
