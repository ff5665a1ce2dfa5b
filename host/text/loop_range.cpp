#include "host/text/loop_range.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace shadertwin {
namespace {

constexpr std::array<std::string_view, 13> writing = {
    "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "++", "--"};

bool writes(const std::string& token) {
  return std::find(writing.begin(), writing.end(), token) != writing.end();
}

// `for (int NAME = FIRST; NAME < LIMIT; NAME++)`
struct Header {
  int first = 0;
  int last = 0;
};

class LoopReader {
 public:
  LoopReader(const std::vector<PlainToken>& tokens, const Declarations& declarations,
             const ZeroValues& values)
      : tokens_(tokens), declarations_(declarations), values_(values) {}

  std::optional<Header> range(const ForLoop& loop, int declaration) const {
    const std::string& name = text(declaration);
    const int start_end = find(";", declaration, loop.close);
    const int condition_end = find(";", start_end + 1, loop.close);
    const int condition = start_end + 1;
    const int step = condition_end + 1;
    if (condition_end >= loop.close || text(declaration - 1) != "int" || text(declaration + 1) != "=" ||
        text(condition) != name)
      return std::nullopt;
    const auto first = values_.constant(declaration + 2, start_end);
    const auto limit = values_.constant(condition + 2, condition_end);
    if (!first || !limit || loop.close - step != 2) return std::nullopt;
    const std::string op = text(condition + 1);
    const auto steps = [&](const char* by) {
      return (text(step) == by && text(step + 1) == name) || (text(step) == name && text(step + 1) == by);
    };
    if (steps("++") && op == "<") return Header{*first, *limit - 1};
    if (steps("++") && op == "<=") return Header{*first, *limit};
    if (steps("--") && op == ">") return Header{*limit + 1, *first};
    if (steps("--") && op == ">=") return Header{*limit, *first};
    return std::nullopt;
  }

  // Whether anything between two tokens may give the variable another value.
  bool written(int declaration, int first, int end) const {
    for (int i = first; i < end; ++i) {
      if (declarations_.declaration_of(i) != declaration || i == declaration) continue;
      int before = i - 1;
      int behind = i + 1;
      while (before > first && behind + 1 < end && text(before) == "(" && text(behind) == ")") {
        --before;
        ++behind;
      }
      for (const auto& [left, right] : {std::pair(i - 1, i + 1), std::pair(before, behind)})
        if (writes(text(right)) || text(left) == "++" || text(left) == "--") return true;
      const bool alone =
          (text(i - 1) == "(" || text(i - 1) == ",") && (text(i + 1) == ")" || text(i + 1) == ",");
      if (alone && may_be_output()) return true;
    }
    return false;
  }

 private:
  const std::string& text(int token) const { return tokens_[static_cast<std::size_t>(token)].text; }
  int find(const char* token, int first, int end) const {
    while (first < end && text(first) != token) ++first;
    return first;
  }
  bool may_be_output() const {
    return std::any_of(declarations_.variables().begin(), declarations_.variables().end(),
                       [&](const Variable& v) {
                         return v.place == Variable::Place::parameter && v.is_out && text(v.type) == "int";
                       });
  }

  const std::vector<PlainToken>& tokens_;
  const Declarations& declarations_;
  const ZeroValues& values_;
};

}  // namespace

bool stays_below(const std::vector<PlainToken>& tokens, const Declarations& declarations,
                 const ZeroValues& values, int use, int size) {
  const int declaration = declarations.declaration_of(use);
  const LoopReader reader(tokens, declarations, values);
  for (const ForLoop& loop : declarations.loops()) {
    if (declaration <= loop.open || declaration >= loop.close) continue;
    const auto range = reader.range(loop, declaration);
    return range && range->first >= 0 && range->last < size &&
           !reader.written(declaration, loop.close, loop.end);
  }
  return false;
}

}  // namespace shadertwin
