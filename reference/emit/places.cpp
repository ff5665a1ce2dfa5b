#include "reference/emit/places.h"

#include <algorithm>

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

namespace {

// The tokens that the nodes below one stand for.
class TokenFinder : public TIntermTraverser {
 public:
  explicit TokenFinder(const SyntaxTree& tree) : tree_(tree) {}

  int first = -1;
  int last = -1;

  void visitSymbol(TIntermSymbol* node) override { note(*node); }
  void visitConstantUnion(TIntermConstantUnion* node) override { note(*node); }
  bool visitBinary(TVisit, TIntermBinary* node) override { return note(*node); }
  bool visitUnary(TVisit, TIntermUnary* node) override { return note(*node); }
  bool visitAggregate(TVisit, TIntermAggregate* node) override { return note(*node); }
  bool visitSelection(TVisit, TIntermSelection* node) override { return note(*node); }

 private:
  bool note(const TIntermNode& node) {
    const int token = tree_.token_of(node);
    if (token < 0) return true;
    first = first < 0 ? token : std::min(first, token);
    last = std::max(last, token);
    return true;
  }

  const SyntaxTree& tree_;
};

bool opens(const std::string& token) {
  return token == "(" || token == "[";
}
bool closes(const std::string& token) {
  return token == ")" || token == "]";
}
// What may stand in front of a parenthesis and is called.
bool is_called(const std::string& token) {
  return is_identifier(token) && token != "return" && token != "if" && token != "while" && token != "for" &&
         token != "switch" && token != "else";
}

}  // namespace

int Places::of_operation(const TIntermTyped& left, const TIntermTyped& right) {
  const Range from = range_of(left);
  const Range to = range_of(right);
  if (from.last < 0 || to.last < 0) return 0;
  // The operator stands in front of the right operand and its parentheses.
  int sign = to.first - 1;
  while (sign > 0 && opens(tree_.tokens()[static_cast<std::size_t>(sign)].text)) --sign;
  Range range = whole({std::min(from.first, to.first), std::max(from.last, to.last)});
  // A folded product has its first token only.
  const std::string& name = text_at(tree_.tokens(), sign);
  if (const_cast<TIntermTyped&>(right).getAsConstantUnion() != nullptr && (name == "+" || name == "-"))
    range = with_factors(range);
  return add(tree_.line_of_token(sign), text_of(range));
}

int Places::of_call(const TIntermTyped& call) {
  Range range = range_of(call);
  const char* name =
      builtin_name(call.getAsAggregate() != nullptr ? call.getAsAggregate()->getOp() : EOpNull);
  if (name != nullptr && range.last >= 0 && text_at(tree_.tokens(), range.first) != name)
    range = called(range);
  return range.last < 0 ? 0 : add(tree_.line_of_token(range.first), text_of(range));
}

int Places::of_line(SourceLine line) {
  return add(line, "");
}

Places::Range Places::range_of(const TIntermNode& node) const {
  // The tree places what has one operand where the operand begins.
  if (const TIntermUnary* unary = const_cast<TIntermNode&>(node).getAsUnaryNode())
    return called(range_of(*unary->getOperand()));
  TokenFinder finder(tree_);
  const_cast<TIntermNode&>(node).traverse(&finder);  // it has no const traversal
  return finder.last < 0 ? Range{} : whole({finder.first, finder.last});
}

// With the function of which this is the argument, if any.
Places::Range Places::called(Range range) const {
  const std::vector<PlainToken>& tokens = tree_.tokens();
  if (range.last < 0 || !opens(text_at(tokens, range.first - 1)) ||
      !is_called(text_at(tokens, range.first - 2)))
    return range;
  return whole({range.first - 2, range.last});
}

// With what belongs to the first and the last token and is no node of its own: parentheses, the name of a
// function in front of them, and a selection behind.
Places::Range Places::whole(Range range) const {
  const std::vector<PlainToken>& tokens = tree_.tokens();
  const int count = static_cast<int>(tokens.size());
  const auto at = [&](int i) -> const std::string& { return text_at(tokens, i); };
  const auto step = [&](int i) { return opens(at(i)) ? 1 : closes(at(i)) ? -1 : 0; };
  if (is_identifier(at(range.last)) && opens(at(range.last + 1))) ++range.last;
  int depth = 0;
  int lowest = 0;
  for (int i = range.first; i <= range.last; ++i) {
    depth += step(i);
    lowest = std::min(lowest, depth);
  }
  for (int missing = lowest; missing < 0 && range.first > 0;) missing += step(--range.first);
  if (opens(at(range.first)) && range.first > 0 && is_called(at(range.first - 1))) --range.first;
  for (int open = depth - lowest; open > 0 && range.last + 1 < count;) open += step(++range.last);
  while (at(range.last + 1) == "." && is_identifier(at(range.last + 2))) range.last += 2;
  return range;
}

// With the factors and divisors that follow.
Places::Range Places::with_factors(Range range) const {
  const std::vector<PlainToken>& tokens = tree_.tokens();
  const auto at = [&](int i) -> const std::string& { return text_at(tokens, i); };
  while (at(range.last + 1) == "*" || at(range.last + 1) == "/") {
    int factor = range.last + 2;
    while (at(factor) == "-" || at(factor) == "+") ++factor;
    range.last = whole({factor, factor}).last;
  }
  return range;
}

std::string Places::text_of(Range range) const {
  constexpr std::size_t longest = 60;
  std::string text;
  for (int i = range.first; i <= range.last; ++i) {
    const PlainToken& token = tree_.tokens()[static_cast<std::size_t>(i)];
    if (i > range.first && token.space_before) text += ' ';
    text += token.text;
  }
  return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

int Places::add(SourceLine at, const std::string& text) {
  if (at.file < 0) return 0;
  places_.push_back({at, text});
  return static_cast<int>(places_.size()) - 1;
}

}  // namespace shadertwin::emit
