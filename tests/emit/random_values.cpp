#include "tests/emit/random_values.h"

#include <utility>

namespace shadertwin::random_program {

std::string name_of(const Type& type) {
  std::string text;
  const std::string rows = std::to_string(type.rows);
  if (type.structure != nullptr)
    text = type.structure->name;
  else if (type.columns > 1)
    text = "mat" + std::to_string(type.columns) + (type.rows == type.columns ? "" : "x" + rows);
  else if (type.rows > 1)
    text = std::string(type.base == Base::real      ? ""
                       : type.base == Base::integer ? "i"
                       : type.base == Base::natural ? "u"
                                                    : "b") +
           "vec" + rows;
  else
    text = type.base == Base::real      ? "float"
           : type.base == Base::integer ? "int"
           : type.base == Base::natural ? "uint"
                                        : "bool";
  return type.count > 0 ? text + "[" + std::to_string(type.count) + "]" : text;
}

std::uint32_t RandomValues::next() {
  state_ = state_ * 747796405u + 2891336453u;
  const std::uint32_t word = ((state_ >> ((state_ >> 28) + 4)) ^ state_) * 277803737u;
  return (word >> 22) ^ word;
}

std::string RandomValues::fresh(const char* stem) {
  // Now and then a name that hides another, or means something to C++ or to GLSL's built-ins.
  static const std::vector<std::string> odd = {"length", "new", "delete", "near", "pow",  "char",
                                               "rand",   "sin", "auto",   "std",  "glsl", "mask"};
  std::vector<std::string> hidden = odd;
  for (const Variable& variable : variables_)
    if (variable.name[0] == 'v' || variable.name[0] == 'g') hidden.push_back(variable.name);
  if (chance(10)) {
    const std::string& name = one_of(hidden);
    if (taken_.insert(name).second) return name;
  }
  const std::string name = stem + std::to_string(names_++);
  taken_.insert(name);
  return name;
}

Type RandomValues::basic() {
  Type type{static_cast<Base>(below(4))};
  if (chance(50)) type.rows = 2 + below(3);
  if (type.base == Base::real && chance(20)) {
    type.rows = 2 + below(3);
    type.columns = 2 + below(3);
  }
  return type;
}

Type RandomValues::any() {
  Type type = chance(20) && !structures_.empty() ? Type{Base::real, 1, 1, 0, some_structure()} : basic();
  if (chance(15)) type.count = 2 + below(3);
  return type;
}

std::string RandomValues::literal(Base base) {
  switch (base) {
    case Base::real:
      return one_of<std::string>({"0.5", "1.0", "2.", ".25", "3.0", "7.5", "1e1", "0.0625", "-1.5"});
    case Base::integer:
      return one_of<std::string>({"0", "1", "2", "3", "-1", "7", "0x1F", "011", "-13", "100"});
    case Base::natural:
      return one_of<std::string>({"0u", "1u", "2u", "5u", "0xFFu", "31U", "4000000000u"});
    default:
      return chance(50) ? "true" : "false";
  }
}

std::string RandomValues::constant(const Type& type) {
  if (type.is_scalar()) return literal(type.base);
  std::string text = name_of(type) + "(";
  if (type.count > 0 && chance(30)) text = name_of(type.element()) + "[](";
  for (int i = 0; i < parts(type); ++i) text += (i > 0 ? ", " : "") + constant(part(type, i));
  return text + ")";
}

int RandomValues::parts(const Type& type) {
  if (type.count > 0) return type.count;
  if (type.structure != nullptr) return static_cast<int>(type.structure->members.size());
  return type.columns > 1 ? type.columns : type.rows;
}

Type RandomValues::part(const Type& type, int i) {
  if (type.count == 0 && type.structure != nullptr)
    return type.structure->members[static_cast<std::size_t>(i)].type;
  return type.element();
}

void RandomValues::paths(const Type& from, const std::string& text, const Type& wanted, bool as_place,
                         std::vector<std::string>& found, int depth) {
  if (from == wanted) found.push_back(text);
  if (depth == 0) return;
  if (from.count > 0) {
    paths(from.element(), text + "[" + index(from.count) + "]", wanted, as_place, found, depth - 1);
  } else if (from.structure != nullptr) {
    for (const Member& member : from.structure->members)
      paths(member.type, text + "." + member.name, wanted, as_place, found, depth - 1);
  } else if (from.columns > 1) {
    paths(from.element(), text + "[" + index(from.columns) + "]", wanted, as_place, found, depth - 1);
  } else if (from.rows > 1 && wanted.count == 0 && wanted.structure == nullptr && wanted.columns == 1 &&
             wanted.base == from.base) {
    if (wanted.rows == 1 && chance(50))
      found.push_back(text + "[" + index(from.rows) + "]");
    else if (!as_place || wanted.rows <= from.rows)
      found.push_back(text + "." + swizzle(from.rows, wanted.rows, as_place));
  }
}

std::string RandomValues::swizzle(int rows, int count, bool distinct) {
  static const char* const sets[] = {"xyzw", "rgba", "stpq"};
  const char* letters = sets[below(3)];
  std::vector<int> order = {0, 1, 2, 3};
  order.resize(static_cast<std::size_t>(rows));
  for (int i = rows - 1; i > 0; --i)
    std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(below(i + 1))]);
  std::string text;
  for (int i = 0; i < count; ++i)
    text += letters[distinct ? order[static_cast<std::size_t>(i)] : below(rows)];
  return text;
}

std::string RandomValues::index(int count) {
  if (chance(40)) return std::to_string(below(count));
  std::vector<std::string> found;
  for (const Variable& variable : variables_)
    if (may_read(variable)) paths(variable.type, variable.name, integer, false, found, 0);
  if (found.empty()) return "0";
  const std::string chosen = one_of(found);
  if (count == 2 || count == 4) return chosen + " & " + std::to_string(count - 1);
  return "int(uint(" + chosen + ") % " + std::to_string(count) + "u)";
}

std::string RandomValues::read(const Type& type) {
  std::vector<std::string> found;
  for (const Variable& variable : variables_)
    if (may_read(variable)) paths(variable.type, variable.name, type, false, found, 2);
  if (found.empty() || chance(5)) return made(type);
  return one_of(found);
}

std::string RandomValues::made(const Type& type) {
  if (type.is_scalar()) return literal(type.base);
  std::string text = name_of(type) + "(";
  if (type.is_vector() && chance(30)) return text + read({type.base}) + ")";
  if (type.is_matrix() && type.columns <= type.rows && chance(30)) return text + literal(Base::real) + ")";
  for (int i = 0; i < parts(type); ++i) {
    const Type wanted = part(type, i);
    text += (i > 0 ? ", " : "") + (wanted.is_scalar() && chance(50) ? read(wanted) : made(wanted));
  }
  return text + ")";
}

std::string RandomValues::place(const Type& type, const std::set<std::string>& among) {
  std::vector<std::string> found;
  for (const Variable& variable : variables_) {
    if (!variable.writable || (!among.empty() && among.count(variable.name) == 0)) continue;
    if (among.empty() && !may_read(variable)) continue;
    paths(variable.type, variable.name, type, true, found, 3);
  }
  return found.empty() ? "" : one_of(found);
}

}  // namespace shadertwin::random_program
