#include "host/language/directive_expression.h"

#include <charconv>
#include <limits>
#include <vector>

namespace shadertwin {

namespace {

using Kind = PreprocessingToken::Kind;

constexpr std::size_t symbol_limit = 9999;

// How strongly a binary operator binds; 0 for what is none.
int strength(const PreprocessingToken& token) {
  struct Level {
    std::string_view op;
    int strength;
  };
  static constexpr Level levels[] = {{"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4},  {"&", 5},  {"==", 6},
                                     {"!=", 6}, {"<", 7},  {">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8},
                                     {">>", 8}, {"+", 9},  {"-", 9}, {"*", 10}, {"/", 10}, {"%", 10}};
  if (!token.is(Kind::punctuation)) return 0;
  for (const Level& level : levels)
    if (level.op == token.text) return level.strength;
  return 0;
}

// What stands before the operand that is being read: an operator with its left operand, a sign or a
// parenthesis.
struct Waiting {
  enum class Kind { binary, unary, parenthesis };
  Kind kind = Kind::binary;
  std::string_view op;
  int strength = 0;
  std::int32_t left = 0;
  bool short_circuit = false;  // the right operand isn't needed

  // As ANGLE's parser counts: && and || leave a mark behind them.
  std::size_t symbols() const { return kind == Kind::binary ? (strength <= 2 ? 3 : 2) : 1; }
};

class Evaluator {
 public:
  Evaluator(TokenSource& source, PreprocessingToken& token, PreprocessingState& state,
            const ExpressionRules& rules)
      : source_(source), token_(token), state_(state), rules_(rules) {}

  DirectiveExpression run() {
    while (valid_ && read_operand()) {
      bool more = false;
      while (valid_ && !more) {
        if (token_.is(')') && close_parenthesis()) continue;
        more = open_binary();
        if (!more) break;
      }
      if (!more) break;
    }
    if (valid_ && !waiting_.empty()) fail("')' is expected");
    return {value_, valid_ && !told_};
  }

 private:
  void advance() { token_ = source_.next(); }

  void error(const std::string& message) {
    state_.error(token_.line, message);
    told_ = true;
  }
  void fail(const std::string& what) {
    error(what + (token_.ends_directive() ? " before " : " instead of ") + quoted(token_));
    valid_ = false;
  }

  // The stack's bottom, what waits, and one operand or parenthesis more.
  bool fits() {
    if (symbols_ + 2 <= symbol_limit) return true;
    error("the expression is nested too deeply: more than " + std::to_string(symbol_limit) +
          " operators, operands and parentheses wait");
    return valid_ = false;
  }

  void push(const Waiting& waiting) {
    symbols_ += waiting.symbols();
    if (waiting.short_circuit) ++ignoring_;
    waiting_.push_back(waiting);
  }
  void pop() {
    symbols_ -= waiting_.back().symbols();
    if (waiting_.back().short_circuit) --ignoring_;
    waiting_.pop_back();
  }

  // Signs, opening parentheses and one number. False if there is none, with an error.
  bool read_operand() {
    while (token_.is('!') || token_.is('~') || token_.is('-') || token_.is('+') || token_.is('(')) {
      push({.kind = token_.is('(') ? Waiting::Kind::parenthesis : Waiting::Kind::unary, .op = token_.text});
      if (!fits()) return false;
      advance();
    }
    if (token_.is(Kind::integer)) {
      value_ = number();
    } else if (token_.is(Kind::identifier)) {
      if (ignoring_ == 0) error(quoted(token_) + rules_.name_error);
      value_ = 0;
    } else {
      fail("a number or a name is expected");
      return false;
    }
    advance();
    apply_unary();
    return true;
  }

  std::int32_t number() {
    std::string_view digits = token_.text;
    while (digits.ends_with('u') || digits.ends_with('U')) digits.remove_suffix(1);
    int base = 10;
    if (digits.starts_with("0x") || digits.starts_with("0X")) {
      base = 16;
      digits.remove_prefix(2);
    } else if (digits.size() > 1 && digits[0] == '0') {
      base = 8;
    }
    std::uint32_t value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (parsed.ec != std::errc() || (rules_.is_signed && value > std::numeric_limits<std::int32_t>::max()))
      error("the number " + quoted(token_) + " is too large");
    return static_cast<std::int32_t>(value);
  }

  void apply_unary() {
    while (!waiting_.empty() && waiting_.back().kind == Waiting::Kind::unary) {
      const char op = waiting_.back().op[0];
      if (op == '!') value_ = value_ == 0 ? 1 : 0;
      if (op == '~') value_ = ~value_;
      if (op == '-') value_ = static_cast<std::int32_t>(0U - static_cast<std::uint32_t>(value_));
      pop();
    }
  }

  // Applies what waits and binds at least as strongly as an operator that comes.
  void apply_binary(int at_least) {
    while (!waiting_.empty() && waiting_.back().kind == Waiting::Kind::binary &&
           waiting_.back().strength >= at_least) {
      const Waiting waiting = waiting_.back();
      pop();
      value_ = calculate(waiting.left, waiting.op, value_);
    }
  }

  // False if the parenthesis is none of the expression's.
  bool close_parenthesis() {
    apply_binary(0);
    if (waiting_.empty()) return false;
    ++symbols_;
    const bool fit = fits();
    --symbols_;
    if (!fit) return true;
    pop();
    advance();
    apply_unary();
    return true;
  }

  // Whether an operator comes; without one, whatever has no open parenthesis is applied.
  bool open_binary() {
    const int coming = strength(token_);
    apply_binary(coming);
    if (coming == 0) return false;
    Waiting waiting{.op = token_.text, .strength = coming, .left = value_};
    waiting.short_circuit = (coming == 1 && value_ != 0) || (coming == 2 && value_ == 0);
    push(waiting);
    if (!fits()) return false;
    advance();
    return true;
  }

  std::int32_t calculate(std::int32_t left, std::string_view op, std::int32_t right) {
    const auto a = static_cast<std::uint32_t>(left);
    const auto b = static_cast<std::uint32_t>(right);
    const auto wrapped = [](std::uint32_t value) { return static_cast<std::int32_t>(value); };
    const bool shift_fits = right >= 0 && right <= 31;
    if (op == "||") return left != 0 || right != 0 ? 1 : 0;
    if (op == "&&") return left != 0 && right != 0 ? 1 : 0;
    if (op == "|") return left | right;
    if (op == "^") return left ^ right;
    if (op == "&") return left & right;
    if (op == "==") return left == right ? 1 : 0;
    if (op == "!=") return left != right ? 1 : 0;
    if (op == "<") return left < right ? 1 : 0;
    if (op == ">") return left > right ? 1 : 0;
    if (op == "<=") return left <= right ? 1 : 0;
    if (op == ">=") return left >= right ? 1 : 0;
    if (op == "<<" || op == ">>") {
      if (!shift_fits) return undefined("a shift by less than 0 or more than 31", left, op, right);
      return wrapped(op == "<<" ? a << b : a >> b);
    }
    if (op == "+") return wrapped(a + b);
    if (op == "-") return wrapped(a - b);
    if (op == "*") return wrapped(a * b);
    if (right == 0) return undefined("a division by zero", left, op, right);
    const bool overflows = left == std::numeric_limits<std::int32_t>::min() && right == -1;
    if (op == "/") return overflows ? std::numeric_limits<std::int32_t>::max() : left / right;
    return overflows ? 0 : left % right;
  }

  std::int32_t undefined(const char* what, std::int32_t left, std::string_view op, std::int32_t right) {
    if (ignoring_ == 0)
      error(std::string(what) + ": " + std::to_string(left) + " " + std::string(op) + " " +
            std::to_string(right));
    return 0;
  }

  TokenSource& source_;
  PreprocessingToken& token_;
  PreprocessingState& state_;
  const ExpressionRules& rules_;
  std::vector<Waiting> waiting_;
  std::size_t symbols_ = 0;
  int ignoring_ = 0;  // operands within each other that aren't needed
  std::int32_t value_ = 0;
  bool valid_ = true;
  bool told_ = false;
};

}  // namespace

DirectiveExpression evaluate(TokenSource& source, PreprocessingToken& token, PreprocessingState& state,
                             const ExpressionRules& rules) {
  return Evaluator(source, token, state, rules).run();
}

}  // namespace shadertwin
