#include "host/text/zero_values.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace shadertwin {
namespace {

// More would be slow to compile, and a loop does as well.
constexpr int most_values = 256;

const std::set<std::string> precisions = {"highp", "mediump", "lowp"};

// Constant integer expressions by recursive descent. Operands are literals, constants and array sizes.
class ConstantExpression {
 public:
  ConstantExpression(const ZeroValues& values, const std::vector<PlainToken>& tokens,
                     const Declarations& declarations, int first, int end)
      : values_(values), tokens_(tokens), declarations_(declarations), at_(first), end_(end) {}

  std::optional<int> value() {
    const auto sum = shifted();
    return at_ == end_ ? sum : std::nullopt;
  }

 private:
  const std::string& text() const {
    static const std::string none;
    return at_ < end_ ? tokens_[static_cast<std::size_t>(at_)].text : none;
  }
  bool accept(const char* expected) {
    if (text() != expected) return false;
    ++at_;
    return true;
  }

  std::optional<int> shifted() {
    auto left = sum();
    while (left && (text() == "<<" || text() == ">>")) {
      const bool up = tokens_[static_cast<std::size_t>(at_++)].text == "<<";
      const auto right = sum();
      if (!right || *right < 0 || *right > 30 || *left < 0) return std::nullopt;
      left = up ? checked(static_cast<long long>(*left) << *right) : *left >> *right;
    }
    return left;
  }

  std::optional<int> sum() {
    auto left = product();
    while (left && (text() == "+" || text() == "-")) {
      const bool add = tokens_[static_cast<std::size_t>(at_++)].text == "+";
      const auto right = product();
      if (!right) return right;
      left = checked(static_cast<long long>(*left) + (add ? *right : -static_cast<long long>(*right)));
    }
    return left;
  }

  std::optional<int> product() {
    auto left = operand();
    while (left && (text() == "*" || text() == "/")) {
      const bool multiply = tokens_[static_cast<std::size_t>(at_++)].text == "*";
      const auto right = operand();
      if (!right || (!multiply && *right == 0)) return std::nullopt;
      left =
          checked(multiply ? static_cast<long long>(*left) * *right : static_cast<long long>(*left) / *right);
    }
    return left;
  }

  std::optional<int> operand() {
    if (accept("+")) return operand();
    if (accept("-")) {
      const auto value = operand();
      return value ? checked(-static_cast<long long>(*value)) : value;
    }
    if (accept("int") || accept("uint")) return text() == "(" ? operand() : std::nullopt;
    if (accept("(")) {
      const auto inner = shifted();
      return accept(")") ? inner : std::nullopt;
    }
    return is_identifier(text()) ? name() : literal();
  }

  std::optional<int> literal() {
    std::string digits = text();
    if (digits.empty()) return std::nullopt;
    ++at_;
    if (digits.back() == 'u' || digits.back() == 'U') digits.pop_back();
    const bool hexadecimal = digits.size() > 2 && (digits[1] == 'x' || digits[1] == 'X');
    if (!hexadecimal && digits.size() > 1 && digits[0] == '0') return std::nullopt;  // octal
    const char* first = digits.data() + (hexadecimal ? 2 : 0);
    const char* last = digits.data() + digits.size();
    int value = 0;
    const auto [rest, failure] = std::from_chars(first, last, value, hexadecimal ? 16 : 10);
    return failure == std::errc() && rest == last ? std::optional(value) : std::nullopt;
  }

  std::optional<int> name() {
    const Variable* variable = values_.variable(declarations_.declaration_of(at_++));
    if (variable == nullptr) return std::nullopt;
    if (accept(".")) {
      if (!accept("length") || !accept("(") || !accept(")")) return std::nullopt;
      return values_.array_size(*variable);
    }
    const std::string& type = tokens_[static_cast<std::size_t>(variable->type)].text;
    if (!variable->is_const || !variable->initialised || (type != "int" && type != "uint") ||
        variable->end != variable->name + 1)
      return std::nullopt;
    int last = variable->end + 1;
    for (int depth = 0; last < static_cast<int>(tokens_.size()); ++last) {
      const std::string& token = tokens_[static_cast<std::size_t>(last)].text;
      if (token == "(") ++depth;
      if (token == ")") --depth;
      if (depth == 0 && (token == ";" || token == ",")) break;
    }
    return values_.constant(variable->end + 1, last);
  }

  static std::optional<int> checked(long long value) {
    constexpr long long limit = 1LL << 30;
    return value > -limit && value < limit ? std::optional(static_cast<int>(value)) : std::nullopt;
  }

  const ZeroValues& values_;
  const std::vector<PlainToken>& tokens_;
  const Declarations& declarations_;
  int at_;
  int end_;
};

std::string builtin_zero(const std::string& type) {
  if (type == "float") return "0.0";
  if (type == "int") return "0";
  if (type == "uint") return "0u";
  if (type == "bool") return "false";
  // Names that only begin like these are the shader's own.
  const auto is_size = [](const std::string& text) {
    const auto digit = [](char c) { return c >= '2' && c <= '4'; };
    return (text.size() == 1 && digit(text[0])) ||
           (text.size() == 3 && digit(text[0]) && text[1] == 'x' && digit(text[2]));
  };
  for (const std::string prefix : {"vec", "ivec", "uvec", "mat", "bvec"}) {
    if (type.rfind(prefix, 0) == 0 && is_size(type.substr(prefix.size())))
      return type + (prefix == "bvec" ? "(false)" : "(0)");
  }
  return "";
}

}  // namespace

ZeroValues::ZeroValues(const std::vector<PlainToken>& tokens, const Declarations& declarations)
    : tokens_(tokens), declarations_(declarations) {
  for (const Variable& variable : declarations_.variables()) {
    if (variable.name >= 0) variables_[variable.name] = &variable;
  }
  for (int i = 0; i < static_cast<int>(tokens_.size()); ++i) {
    if (text(i) == "struct") read_structure(i);
  }
}

const std::string& ZeroValues::text(int token) const {
  static const std::string none;
  return token >= 0 && token < static_cast<int>(tokens_.size())
             ? tokens_[static_cast<std::size_t>(token)].text
             : none;
}

const Variable* ZeroValues::variable(int declaration) const {
  const auto found = variables_.find(declaration);
  return found == variables_.end() ? nullptr : found->second;
}

int ZeroValues::skip_brackets(int token) const {
  while (text(token) == "[") {
    while (!text(token).empty() && text(token) != "]") ++token;
    ++token;
  }
  return token;
}

void ZeroValues::read_structure(int keyword) {
  Structure structure;
  if (!is_identifier(text(keyword + 1)) || text(keyword + 2) != "{") return;
  structure.name = keyword + 1;
  int at = keyword + 3;
  while (!text(at).empty() && text(at) != "}") {
    while (precisions.count(text(at)) != 0) ++at;
    Member member;
    member.type = at;
    member.type_end = skip_brackets(at + 1);
    at = member.type_end;
    do {
      member.name = text(at) == "," ? at + 1 : at;
      member.end = at = skip_brackets(member.name + 1);
      structure.members.push_back(member);
    } while (text(at) == ",");
    if (text(at) != ";") return;  // not what a structure looks like
    ++at;
  }
  structures_.push_back(structure);
}

std::optional<int> ZeroValues::constant(int first, int end) const {
  return ConstantExpression(*this, tokens_, declarations_, first, end).value();
}

std::optional<int> ZeroValues::array_size(const Variable& variable) const {
  const bool on_type = variable.type_end - variable.type > 3 && text(variable.type) != "struct";
  const bool on_name = variable.end - variable.name > 3;
  if (on_type == on_name) return std::nullopt;
  return on_type ? constant(variable.type + 2, variable.type_end - 1)
                 : constant(variable.name + 2, variable.end - 1);
}

ZeroValues::Text ZeroValues::plain(int type) const {
  const std::string name = text(text(type) == "struct" ? type + 1 : type);
  if (const std::string zero = builtin_zero(name); !zero.empty()) return {zero, 1};
  // The last one of that name before the use, as scopes have it in all but odd cases.
  const Structure* found = nullptr;
  for (const Structure& structure : structures_) {
    if (text(structure.name) == name && structure.name <= type + 1) found = &structure;
  }
  if (found == nullptr) return {};
  Text result;
  for (const Member& member : found->members) {
    const Text value = whole(member.type, member.type_end, member.name, member.end);
    result.values += value.values;
    if (value.text.empty() || result.values > most_values) return {};
    result.text += (result.text.empty() ? "" : ", ") + value.text;
  }
  return {name + "(" + result.text + ")", result.values};
}

ZeroValues::Text ZeroValues::sized(int type, int first, int end) const {
  const auto size = constant(first, end);
  const Text element = plain(type);
  if (!size || *size < 1 || element.text.empty() || *size > most_values / element.values) return {};
  const std::string& name = text(text(type) == "struct" ? type + 1 : type);
  std::string result = name + "[" + std::to_string(*size) + "](" + element.text;
  for (int i = 1; i < *size; ++i) result += ", " + element.text;
  return {result + ")", *size * element.values};
}

ZeroValues::Text ZeroValues::whole(int type, int type_end, int name, int end) const {
  const bool on_type = text(type) != "struct" && type_end > type + 1;
  const bool on_name = end > name + 1;
  if (on_type && on_name) return {};
  if (on_type) return sized(type, type + 2, type_end - 1);
  return on_name ? sized(type, name + 2, end - 1) : plain(type);
}

std::string ZeroValues::of(const Variable& variable) const {
  return whole(variable.type, variable.type_end, variable.name, variable.end).text;
}

std::string ZeroValues::of_result(const FunctionBody& function) const {
  return whole(function.type, function.type_end, 0, 1).text;
}

std::string ZeroValues::of_element(const Variable& variable) const {
  const bool on_type = text(variable.type) != "struct" && variable.type_end > variable.type + 1;
  return on_type || variable.end > variable.name + 1 ? plain(variable.type).text : "";
}

}  // namespace shadertwin
