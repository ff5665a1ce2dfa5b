#include "host/text/define_operations.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "host/text/known_zeros.h"
#include "host/text/operands.h"
#include "host/text/zero_values.h"

namespace shadertwin {
namespace {

using glslang::TIntermAggregate;
using glslang::TIntermTyped;

// The functions of numbers. Each computes what GLSL has first, so that nothing needs to branch.
struct Definition {
  std::string_view name;
  std::string_view text;
};
constexpr std::array<Definition, 9> definitions = {{
    {"mod", "float shadertwin_safe_mod(float x, float y) { float r = mod(x, y); return y == 0.0 ? x : r; }"},
    {"pow",
     "float shadertwin_safe_pow(float x, float y) { float r = pow(x, y); "
     "return y == 0.0 ? 1.0 : x == 0.0 && y < 0.0 ? uintBitsToFloat(0x7f800000u) : r; }"},
    {"atan",
     "float shadertwin_safe_atan(float y, float x) { float r = atan(y, x); "
     "return x == 0.0 && y == 0.0 ? 0.0 : r; }"},
    {"smoothstep",
     "float shadertwin_safe_smoothstep(float a, float b, float x) { float r = smoothstep(a, b, x); "
     "return a == b ? float(x > a) : r; }"},
    {"int",
     "int shadertwin_safe_int(float x) { int r = int(x); "
     "return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; }"},
    {"uint",
     "uint shadertwin_safe_uint(float x) { uint r = uint(x); "
     "return x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u; }"},
    // Division of or by a zero that is known before the shader runs: some drivers make it zero or anything.
    // So zeros, infinities and NaN are made of bits, without arithmetic on them.
    {"over",
     "float shadertwin_safe_over(float a, float b) { float r = a / b; "
     "bool zero = a == 0.0, infinite = b == 0.0, is_nan = zero && infinite || a != a || b != b; "
     "uint sign = (floatBitsToUint(a) ^ floatBitsToUint(b)) & 0x80000000u; "
     "return is_nan ? uintBitsToFloat(0x7fc00000u) : zero ? uintBitsToFloat(sign) : "
     "infinite ? uintBitsToFloat(sign | 0x7f800000u) : r; }"},
    // No division by 0 or -1 even of constants: a driver that computes -2147483648 / -1 itself may trap.
    {"divide",
     "int shadertwin_safe_divide(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a / d; "
     "return b == 0 ? -1 : b == -1 ? -a : r; }"},
    {"modulo",
     "int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; "
     "return b == 0 ? -1 : r; }"},
}};

// How many elements a type has, and of what type they are; a number has one.
int elements_of(const std::string& type) {
  const std::size_t at = type.find_first_of("234");
  return at == std::string::npos ? 1 : type[at] - '0';
}
std::string element_of(const std::string& type) {
  if (type.starts_with("mat")) return "vec" + type.substr(5);
  return type[0] == 'i' ? "int" : type[0] == 'u' ? "uint" : "float";
}

// Numbers and vectors of them.
bool is_simple(const TIntermTyped& node) {
  const glslang::TType& type = node.getType();
  return !type.isMatrix() && !type.isArray() && !type.isStruct() &&
         (type.getBasicType() == glslang::EbtFloat || type.getBasicType() == glslang::EbtInt ||
          type.getBasicType() == glslang::EbtUint);
}

bool is_nonzero(const TIntermTyped& node) {
  return is_constant_that(node, [](double x) { return x != 0; });
}
bool is_positive(const TIntermTyped& node) {
  return is_constant_that(node, [](double x) { return x > 0; });
}
// Of constants of one size, or of numbers and vectors: whether every component of `low` is less.
bool is_below(const TIntermTyped& low, const TIntermTyped& high) {
  double most = -1e300;
  double least = 1e300;
  const auto note_most = [&most](double x) { return most = std::max(most, x), true; };
  const auto note_least = [&least](double x) { return least = std::min(least, x), true; };
  return is_constant_that(low, note_most) && is_constant_that(high, note_least) && most < least;
}

// Visits what is further in first.
class Operations : public glslang::TIntermTraverser {
 public:
  Operations(const SyntaxTree& tree, RewrittenLines& edits)
      : TIntermTraverser(false, false, true),
        tree_(tree),
        tokens_(tree.tokens()),
        edits_(edits),
        zeros_(tree) {}

  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    kept_.insert(tree_.token_of(*node));
    const TIntermTyped& left = *node->getLeft();
    const TIntermTyped& right = *node->getRight();
    const glslang::TOperator op = node->getOp();
    const bool divides = op == glslang::EOpDiv || op == glslang::EOpDivAssign;
    const bool remains = op == glslang::EOpMod || op == glslang::EOpModAssign;
    if (node->getBasicType() == glslang::EbtInt) {
      if (remains) replace_operator(*node, "modulo");
      if (divides && !is_constant_that(right, [](double x) { return x != 0 && x != -1; }))
        replace_operator(*node, "divide");
    }
    if (node->getBasicType() == glslang::EbtFloat && divides &&
        (zeros_.may_be_zero(right) || (!is_positive(right) && zeros_.may_be_zero(left))))
      replace_operator(*node, "over");
    return true;
  }

  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    const bool to_int = node->getOp() == glslang::EOpConvFloatToInt;
    if (!to_int && node->getOp() != glslang::EOpConvFloatToUint) return true;
    const TIntermTyped& operand = *node->getOperand();
    if (is_simple(operand)) convert(operand, to_int ? "int" : "uint");
    return true;
  }

  bool visitAggregate(glslang::TVisit, TIntermAggregate* node) override {
    const glslang::TIntermSequence& sequence = node->getSequence();
    std::vector<const TIntermTyped*> parts;
    for (const TIntermNode* part : sequence) parts.push_back(part->getAsTyped());
    if (parts.size() < 2 || std::any_of(parts.begin(), parts.end(),
                                        [](auto* part) { return part == nullptr || !is_simple(*part); }))
      return true;
    if (std::all_of(parts.begin(), parts.end(), [](auto* part) { return part->getAsConstantUnion(); }))
      return true;  // where a constant is needed, no function of ours may stand
    switch (node->getOp()) {
      case glslang::EOpMod:
        if (!is_nonzero(*parts[1])) rename_call(*node, "mod", parts);
        break;
      case glslang::EOpPow:
        if (!is_positive(*parts[0]) && !is_positive(*parts[1])) rename_call(*node, "pow", parts);
        break;
      case glslang::EOpAtan:
        if (!is_nonzero(*parts[0]) && !is_nonzero(*parts[1])) rename_call(*node, "atan", parts);
        break;
      case glslang::EOpSmoothStep:
        if (!is_below(*parts[0], *parts[1]) && !is_below(*parts[1], *parts[0]))
          rename_call(*node, "smoothstep", parts);
        break;
      case glslang::EOpClamp:
        if (!is_below(*parts[1], *parts[2])) rename_call(*node, "clamp", parts);
        break;
      default:
        break;
    }
    return true;
  }

  // Divisions of integer constants by 0 or -1, which the tree has folded: a driver that folds them, too, may
  // give anything, or trap. No function of ours may stand in a constant.
  void divide_constants() {
    const ZeroValues values(tokens_, tree_.declarations());
    for (int i = 0; i < static_cast<int>(tokens_.size()); ++i) {
      const bool divides = text(i) == "/";
      if ((!divides && text(i) != "%") || kept_.contains(i)) continue;
      const TokenRange left = left_operand(tokens_, i);
      const TokenRange right = right_operand(tokens_, i);
      const auto divisor = values.constant(right.first, right.last + 1);
      if (!divisor || (*divisor != 0 && (*divisor != -1 || is_unsigned(right)))) continue;
      // ~(a * 0) is -1, or the largest unsigned number.
      around_.push_back({{left.first, right.last}, *divisor == 0 ? "~((" : "(("});
      edits_.instead[i] = ") * (";
      edits_.after[static_cast<std::size_t>(right.last)] += *divisor == 0 || divides ? ")" : ") * 0";
    }
  }

  // Puts the collected texts around the tokens: of two that begin or end at the same token, the longer
  // outside.
  std::string finish() {
    std::stable_sort(around_.begin(), around_.end(),
                     [](const Around& a, const Around& b) { return a.range.size() < b.range.size(); });
    for (const Around& around : around_) {
      std::string& before = edits_.before[static_cast<std::size_t>(around.range.first)];
      before = around.before + before;
      edits_.after[static_cast<std::size_t>(around.range.last)] += ")";
    }
    return functions_;
  }

 private:
  struct Around {
    TokenRange range;
    std::string before;
  };
  using Types = std::vector<std::string>;

  const std::string& text(int token) const { return text_at(tokens_, token); }

  static Types types_of(const std::vector<const TIntermTyped*>& nodes) {
    Types types;
    for (const TIntermTyped* node : nodes) types.push_back(type_name(node->getType()));
    return types;
  }

  void rename_call(const TIntermAggregate& node, const std::string& name,
                   const std::vector<const TIntermTyped*>& parts) {
    const int token = name_of_call(tokens_, tree_.token_of(node));
    if (text(token) != name) return;
    edits_.instead[token] = "shadertwin_safe_" + name;
    define(name, type_name(node.getType()), types_of(parts));
  }

  void replace_operator(const glslang::TIntermBinary& node, const std::string& name) {
    const int token = tree_.token_of(node);
    const bool assigns = text(token) == "/=" || text(token) == "%=";
    if (!assigns && text(token) != "/" && text(token) != "%") return;
    const TokenRange range = {left_operand(tokens_, token).first, right_operand(tokens_, token).last};
    around_.push_back({range, "shadertwin_safe_" + name + (assigns ? "_to(" : "(")});
    edits_.instead[token] = ",";
    const Types types = types_of({node.getLeft(), node.getRight()});
    define(name, type_name(node.getType()), types);
    if (assigns)
      add(types[0] + " shadertwin_safe_" + name + "_to(inout " + types[0] + " a, " + types[1] +
          " b) { return a = shadertwin_safe_" + name + "(a, b); }");
  }

  // The tree has the conversion, of an operand somewhere among a constructor's arguments: of the innermost
  // one that no conversion further in has taken.
  void convert(const TIntermTyped& operand, const std::string& name) {
    const int inside = tree_.token_of(operand);
    const std::string vector = name == "int" ? "ivec" : "uvec";
    for (int open = enclosing_bracket(tokens_, inside); open > 0; open = enclosing_bracket(tokens_, open)) {
      const std::string& constructor = text(open - 1);
      if (constructor != name && !constructor.starts_with(vector)) continue;
      const TokenRange argument = argument_around(tokens_, open, inside);
      if (!converted_.insert(argument.first).second) continue;
      around_.push_back({argument, "shadertwin_safe_" + name + "("});
      const int size = operand.getType().getVectorSize();
      define(name, size == 1 ? name : vector + std::to_string(size), types_of({&operand}));
      return;
    }
  }

  bool is_unsigned(const TokenRange& range) const {
    for (int i = range.first; i <= range.last; ++i)
      if (text(i) == "uint" || text(i).starts_with("uvec")) return true;
    return false;
  }

  // Our function for these types, and what it needs.
  void define(const std::string& name, const std::string& result, const Types& types) {
    static constexpr std::array<std::string_view, 3> names = {"a", "b", "c"};
    std::string head = result + " shadertwin_safe_" + name + "(";
    for (std::size_t i = 0; i < types.size(); ++i)
      head += (i > 0 ? ", " : "") + types[i] + ' ' + std::string(names.at(i));
    if (name == "clamp") {
      add(head + ") { return min(max(a, b), c); }");
      return;
    }
    const int count = elements_of(result);
    if (count == 1) {
      for (const Definition& definition : definitions)
        if (definition.name == name) add(std::string(definition.text));
      return;
    }
    Types parts;
    for (const std::string& type : types) parts.push_back(element_of(type));
    define(name, element_of(result), parts);
    std::string body;
    for (int element = 0; element < count; ++element) {
      body += (element > 0 ? ", shadertwin_safe_" : "shadertwin_safe_") + name + "(";
      for (std::size_t i = 0; i < types.size(); ++i) {
        body += (i > 0 ? ", " : "") + std::string(names.at(i));
        if (types[i].starts_with("mat"))
          body += '[' + std::to_string(element) + ']';
        else if (elements_of(types[i]) > 1)
          body += std::string(".") + "xyzw"[element];
      }
      body += ")";
    }
    add(head + ") { return " + result + "(" + body + "); }");
  }

  void add(const std::string& function) {
    if (known_.insert(function).second) functions_ += ' ' + function;
  }

  const SyntaxTree& tree_;
  const std::vector<PlainToken>& tokens_;
  RewrittenLines& edits_;
  KnownZeros zeros_;
  std::vector<Around> around_;
  std::set<int> kept_;       // operators that the tree has
  std::set<int> converted_;  // first tokens of arguments
  std::set<std::string> known_;
  std::string functions_;
};

}  // namespace

std::string define_operations(const SyntaxTree& tree, RewrittenLines& edits) {
  Operations operations(tree, edits);
  const_cast<TIntermAggregate&>(tree.root()).traverse(&operations);
  operations.divide_constants();
  return operations.finish();
}

}  // namespace shadertwin
