#include "tests/emit/random_expressions.h"

#include <algorithm>

namespace shadertwin::random_program {

std::string RandomExpressions::expression(const Type& type, int depth, bool effects) {
  if (effects && chance(25)) {
    if (const std::string text = effect(type, depth); !text.empty()) return text;
  }
  if (depth <= 0 || chance(15)) return read(type);
  if (type.structure == nullptr && type.count == 0 && chance(15)) {
    // Sequenced: effects may stand in each part.
    if (chance(20) && effects)
      return "(" + expression(basic(), depth - 2, true) + ", " + expression(type, depth - 1, true) + ")";
  }
  if (chance(12)) {
    const bool by_macro = chance(30);
    const std::string c = expression(truth, depth - 1, effects);
    const std::string yes = expression(type, depth - 1, effects);
    const std::string no = expression(type, depth - 1, effects);
    if (type.count == 0 && type.structure == nullptr) {
      if (by_macro) return "PICK(" + c + ", " + yes + ", " + no + ")";
      return "(" + c + " ? " + yes + " : " + no + ")";
    }
  }
  if (chance(18)) {
    if (const std::string text = call(type, depth, effects); !text.empty()) return text;
  }
  if (type.count > 0 || type.structure != nullptr) return read(type);
  if (type.is_matrix()) return matrix(type, depth, effects);
  switch (type.base) {
    case Base::real:
      return real_value(type, depth, effects);
    case Base::truth:
      return truth_value(type, depth, effects);
    default:
      return whole_value(type, depth, effects);
  }
}

std::string RandomExpressions::pair(const Type& a, const char* sign, const Type& b, int depth, bool effects) {
  const bool left = chance(50);
  return expression(a, depth - 1, effects && left) + " " + sign + " " +
         expression(b, depth - 1, effects && !left);
}

std::string RandomExpressions::real_value(const Type& type, int depth, bool effects) {
  const auto one = [&] { return expression(type, depth - 1, effects); };
  switch (below(14)) {
    case 0:
      return "q(" + pair(type, "*", type, depth, effects) + ")";
    case 1:
      return "q(" + pair(type, "*", chance(50) ? real : type, depth, effects) + ")";
    case 2:
      return "Q(" + pair(type, "-", type, depth, effects) + ")";
    case 3:
      return "abs(" + one() + ")";
    case 4:
      return one_of<std::string>({"floor(", "fract(", "sign(", "ceil(", "trunc("}) + one() + ")";
    case 5:
      return one_of<std::string>({"min(", "max(", "step("}) + pair(type, ",", type, depth, effects) + ")";
    case 6:
      return "q(clamp(" + one() + ", " + name_of(type) + "(-3.0), " + name_of(type) + "(9.5)))";
    case 7:
      return "q(mix(" + read(type) + ", " + one() + ", " + one_of<std::string>({"0.5", "0.25", "1.0"}) + "))";
    case 8:
      return "q(-(" + one() + "))";
    case 9: {
      const Type from = Type{static_cast<Base>(1 + below(3)), type.rows};
      const std::string value = expression(from, depth - 1, effects);
      if (from.base == Base::truth) return name_of(type) + "(" + value + ")";
      const std::string mask = from.base == Base::natural ? "63u" : "63";
      return name_of(type) + "((" + value + ") & " + mask + ")";
    }
    case 10:
      if (type.is_scalar())
        return "q(" + std::string("dot(") + pair({Base::real, 3}, ",", {Base::real, 3}, depth, effects) +
               "))";
      return name_of(type) + "(" + joined(type, depth, effects) + ")";
    case 11: {
      const int n = 2 + below(3);
      const Type by{Base::real, n};
      if (!type.is_vector()) return "q(" + one() + " / 4.0)";
      const std::string m = "(" + read(Type{Base::real, type.rows, n}) + ")";
      return "q(q(" + m + " * " + expression(by, depth - 1, effects) + "))";
    }
    case 12:
      if (!type.is_vector() && type.rows == 1)
        return "AT(" + pair(integer, ",", integer, depth, effects) + ")." + swizzle(4, 1, false);
      return "mix(" + read(type) + ", " + one() + ", " + read(Type{Base::truth, type.rows}) + ")";
    default:
      return "q(" + pair(type, "+", type, depth, effects) + ")";
  }
}

std::string RandomExpressions::joined(const Type& type, int depth, bool effects) {
  std::string text;
  const int chosen = below(3);
  for (int left = type.rows, i = 0; left > 0; ++i) {
    const int n = left == 1 ? 1 : 1 + below(std::min(left, 3));
    text += (i > 0 ? ", " : "") + expression(Type{type.base, n}, depth - 1, effects && i == chosen);
    left -= n;
  }
  return text;
}

std::string RandomExpressions::whole_value(const Type& type, int depth, bool effects) {
  const bool is_uint = type.base == Base::natural;
  const std::string u = is_uint ? "u" : "";
  const auto one = [&] { return expression(type, depth - 1, effects); };
  switch (below(11)) {
    case 0:
    case 1:
      return "(" + pair(type, one_of<std::string>({"+", "-", "*"}).c_str(), type, depth, effects) + ")";
    case 2:
      return "(" + pair(type, one_of<std::string>({"&", "|", "^"}).c_str(), type, depth, effects) + ")";
    case 3:
      return "(" + one() + one_of<std::string>({" << ", " >> "}) + "(" +
             one_of<std::string>({"3", "1u", "7"}) + "))";
    case 4:
      return "(" + one() + " / " + one_of<std::string>({"7", "3", "16"}) + u + ")";
    case 5:
      return is_uint ? "(" + one() + " % " + one_of<std::string>({"7u", "3u", "10u"}) + ")"
                     : "((" + one() + " & 1023) % " + one_of<std::string>({"7", "3", "10"}) + ")";
    case 6:
      return "(~" + one() + ")";
    case 7:
      return one_of<std::string>({"min(", "max("}) + pair(type, ",", type, depth, effects) + ")";
    case 8: {
      Type from = type;
      from.base = static_cast<Base>(below(4));
      if (from.base == Base::real && is_uint)
        return name_of(type) + "(abs(" + expression(from, depth - 1, effects) + "))";
      return name_of(type) + "(" + expression(from, depth - 1, effects) + ")";
    }
    case 9:
      if (type.is_vector()) return name_of(type) + "(" + joined(type, depth, effects) + ")";
      return "(" + pair(type, "-", type, depth, effects) + ")";
    default:
      return is_uint ? "(" + one() + " * 1664525u + 1013904223u)" : "abs(" + one() + " >> 2)";
  }
}

std::string RandomExpressions::truth_value(const Type& type, int depth, bool effects) {
  Type of{static_cast<Base>(below(3)), type.rows};
  if (type.is_vector()) {
    if (chance(20)) return "not(" + expression(type, depth - 1, effects) + ")";
    if (chance(20)) return name_of(type) + "(" + joined(type, depth, effects) + ")";
    return one_of<std::string>(
               {"lessThan(", "greaterThan(", "lessThanEqual(", "greaterThanEqual(", "equal(", "notEqual("}) +
           pair(of, ",", of, depth, effects) + ")";
  }
  switch (below(8)) {
    case 0:
      return "(" + expression(truth, depth - 1, effects) + " && " + expression(truth, depth - 1, effects) +
             ")";
    case 1:
      return "(" + expression(truth, depth - 1, effects) + " || " + expression(truth, depth - 1, effects) +
             ")";
    case 2:
      return "(" + pair(truth, "^^", truth, depth, effects) + ")";
    case 3:
      return "!" + expression(truth, depth - 1, effects);
    case 4: {
      const Type whole = chance(60) ? basic() : Type{Base::real, 1, 1, 0, some_structure()};
      return "(" + pair(whole, chance(50) ? "==" : "!=", whole, depth, effects) + ")";
    }
    case 5:
      return one_of<std::string>({"any(", "all("}) +
             expression(Type{Base::truth, 2 + below(3)}, depth - 1, effects) + ")";
    default:
      return "(" + pair(of, one_of<std::string>({"<", ">", "<=", ">="}).c_str(), of, depth, effects) + ")";
  }
}

std::string RandomExpressions::matrix(const Type& type, int depth, bool effects) {
  const Type column{Base::real, type.rows};
  switch (below(5)) {
    case 0:
      return "transpose(" + expression(Type{Base::real, type.columns, type.rows}, depth - 1, effects) + ")";
    case 1: {
      std::string text = name_of(type) + "(";
      const int chosen = below(type.columns);
      for (int i = 0; i < type.columns; ++i)
        text += (i > 0 ? ", " : "") + expression(column, depth - 1, effects && i == chosen);
      return text + ")";
    }
    case 2: {
      const Type other{Base::real, 2 + below(3), 2 + below(3)};
      // Mesa 22 mistakes the diagonal of a constant with more columns than rows.
      if (chance(50) && type.columns <= type.rows) return name_of(type) + "(" + literal(Base::real) + ")";
      return name_of(type) + "(" + read(other) + ")";
    }
    default:
      return read(type);
  }
}

std::string RandomExpressions::effect(const Type& type, int depth) {
  const std::string to = place(type, reserved_);
  if (to.empty()) return call(type, depth, true);
  const bool counts = type.count == 0 && type.structure == nullptr && type.base != Base::truth;
  if (counts && type.base != Base::real && chance(50))
    return chance(50) ? "(" + to + one_of<std::string>({"++", "--"}) + ")"
                      : "(" + one_of<std::string>({"++", "--"}) + to + ")";
  if (counts && type.base != Base::real && chance(50))
    return "(" + to + one_of<std::string>({" += ", " -= ", " *= ", " ^= "}) +
           expression(type, depth - 1, false) + ")";
  return "(" + to + " = " + expression(type, depth - 1, false) + ")";
}

std::string RandomExpressions::call(const Type& type, int depth, bool effects) {
  std::vector<const Function*> found;
  for (const Function& function : functions_) {
    if (!function.returns || function.result != type || (function.writes && !effects)) continue;
    if (function.discards || cost_ + function.cost * rounds_ > 6000) continue;
    found.push_back(&function);
  }
  if (found.empty()) return {};
  return call_of(*one_of(found), depth, effects);
}

std::string RandomExpressions::call_of(const Function& function, int depth, bool effects) {
  std::string text = function.name + "(";
  std::set<std::string> used;
  for (std::size_t i = 0; i < function.types.size(); ++i) {
    if (i > 0) text += ", ";
    if (function.passing[i] == Passing::in || function.passing[i] == Passing::const_in) {
      text += expression(function.types[i], depth - 2, false);
      continue;
    }
    // Two parameters never share a variable, and none is one that the function itself may write.
    std::vector<std::string> found;
    std::vector<std::string> owners;
    for (const Variable& variable : variables_) {
      if (!variable.writable || variable.global || used.count(variable.name) != 0) continue;
      if (in_expression_ && reserved_.count(variable.name) == 0) continue;
      const std::size_t before = found.size();
      paths(variable.type, variable.name, function.types[i], true, found, 3);
      owners.resize(found.size(), variable.name);
      if (found.size() == before) continue;
    }
    if (found.empty()) return {};
    const auto chosen = static_cast<std::size_t>(below(static_cast<int>(found.size())));
    used.insert(owners[chosen]);
    text += found[chosen];
  }
  if (function.writes && !effects) return {};
  cost_ += function.cost * rounds_;
  writes_ = writes_ || function.writes;
  return text + ")";
}

std::string RandomExpressions::full(const Type& type, int depth) {
  reserve();
  in_expression_ = true;
  std::string text = expression(type, depth, !reserved_.empty());
  in_expression_ = false;
  reserved_.clear();
  return text;
}

void RandomExpressions::reserve() {
  reserved_.clear();
  if (!chance(45)) return;
  for (const Variable& variable : variables_)
    if (variable.writable && (variable.global || chance(25))) reserved_.insert(variable.name);
  for (const Variable& variable : variables_)
    if (reserved_.count(variable.name) != 0 && variable.global) writes_ = true;
}

}  // namespace shadertwin::random_program
