#include "tests/emit/random_shader.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

namespace shadertwin {
namespace {

enum class Base { real, integer, natural, truth };

struct Structure;

// A scalar has one row and one column, a vector one column, a matrix more.
struct Type {
  Base base = Base::real;
  int rows = 1;
  int columns = 1;
  int count = 0;  // of an array; 0: none
  const Structure* structure = nullptr;

  bool operator==(const Type&) const = default;
  bool is_scalar() const { return !structure && count == 0 && rows == 1 && columns == 1; }
  bool is_vector() const { return !structure && count == 0 && rows > 1 && columns == 1; }
  bool is_matrix() const { return !structure && count == 0 && columns > 1; }
  Type element() const {
    if (count > 0) return {base, rows, columns, 0, structure};
    return columns > 1 ? Type{base, rows} : Type{base};
  }
  Type with_rows(int n) const { return {base, n}; }
};

struct Member {
  Type type;
  std::string name;
};

struct Structure {
  std::string name;
  std::vector<Member> members;
};

struct Variable {
  Type type;
  std::string name;
  bool writable = true;
  bool global = false;
};

enum class Passing { in, const_in, out, inout };

struct Function {
  std::string name;
  bool returns = true;
  Type result;
  std::vector<Type> types;
  std::vector<Passing> passing;
  bool writes = false;  // globals, or through its parameters
  bool discards = false;
  int cost = 1;
};

const Type real{Base::real};
const Type integer{Base::integer};
const Type truth{Base::truth};

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

// q() brings a float back to a multiple of 1/16 in [0, 64) or, with the other one's sign, (-64, 64).
constexpr const char* prologue =
    "#iChannel0 \"self\"\n"
    "#define Q(x) q(x)\n"
    "#define AT(x, y) texelFetch(iChannel0, ivec2((x) & 7, (y) & 7), 0)\n"
    "#define WHEN(c) if (c)\n"
    "#define PICK(c, a, b) ((c) ? (a) : (b))\n"
    "#define TIMES(i, n) for (int i = 0; i < (n); \\\n    ++i)\n";

constexpr const char* helpers =
    "float q(float x) { x = floor(x * 16.0) * 0.0625; return x - 64.0 * floor(x * 0.015625); }\n"
    "vec2 q(vec2 v) { return vec2(q(v.x), q(v.y)); }\n"
    "vec3 q(vec3 v) { return vec3(q(v.xy), q(v.z)); }\n"
    "vec4 q(vec4 v) { return vec4(q(v.xyz), q(v.w)); }\n";

class Writer {
 public:
  explicit Writer(std::uint32_t seed) : state_(seed * 747796405u + 2891336453u) {}

  std::string write() {
    text_ = prologue;
    structures();
    globals();
    text_ += helpers;
    const int functions = 2 + below(4);
    for (int i = 0; i < functions; ++i) function(i);
    main_image();
    return text_;
  }

 private:
  // --- Chance -----------------------------------------------------------------

  std::uint32_t next() {
    state_ = state_ * 747796405u + 2891336453u;
    const std::uint32_t word = ((state_ >> ((state_ >> 28) + 4)) ^ state_) * 277803737u;
    return (word >> 22) ^ word;
  }
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint32_t>(n)); }
  bool chance(int percent) { return below(100) < percent; }
  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }

  std::string fresh(const char* stem) {
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

  // --- Types --------------------------------------------------------------------

  Type basic() {
    Type type{static_cast<Base>(below(4))};
    if (chance(50)) type.rows = 2 + below(3);
    if (type.base == Base::real && chance(20)) {
      type.rows = 2 + below(3);
      type.columns = 2 + below(3);
    }
    return type;
  }
  Type any() {
    Type type = chance(20) && !structures_.empty() ? Type{Base::real, 1, 1, 0, some_structure()} : basic();
    if (chance(15)) type.count = 2 + below(3);
    return type;
  }
  const Structure* some_structure() { return one_of(structures_); }

  void structures() {
    static Structure storage[3];
    const int count = 1 + below(3);
    for (int i = 0; i < count; ++i) {
      Structure& structure = storage[i];
      structure = {"S" + std::to_string(i), {}};
      const int members = 1 + below(4);
      for (int m = 0; m < members; ++m)
        structure.members.push_back({any(), std::string(1, static_cast<char>('a' + m))});
      text_ += "struct " + structure.name + " {";
      for (const Member& member : structure.members) {
        const Type scalar = member.type.count > 0 ? member.type.element() : member.type;
        const std::string size = member.type.count > 0 ? "[" + std::to_string(member.type.count) + "]" : "";
        text_ += " " + name_of(scalar) + " " + member.name + size + ";";
      }
      text_ += " };\n";
      structures_.push_back(&structure);
    }
  }

  void globals() {
    const int count = 3 + below(4);
    for (int i = 0; i < count; ++i) {
      const bool is_const = chance(35);
      const Type type = i == 0 ? integer : any();
      const std::string name = "g" + std::to_string(i);
      const bool initialised = is_const || chance(60);
      text_ += (is_const ? "const " : "") + name_of(type) + " " + name +
               (initialised ? " = " + constant(type) : "") + ";\n";
      variables_.push_back({type, name, !is_const, true});
    }
  }

  // --- Values ---------------------------------------------------------------------

  std::string literal(Base base) {
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

  std::string constant(const Type& type) {
    if (type.is_scalar()) return literal(type.base);
    std::string text = name_of(type) + "(";
    if (type.count > 0 && chance(30)) text = name_of(type.element()) + "[](";
    for (int i = 0; i < parts(type); ++i) text += (i > 0 ? ", " : "") + constant(part(type, i));
    return text + ")";
  }

  static int parts(const Type& type) {
    if (type.count > 0) return type.count;
    if (type.structure != nullptr) return static_cast<int>(type.structure->members.size());
    return type.columns > 1 ? type.columns : type.rows;
  }
  static Type part(const Type& type, int i) {
    if (type.count == 0 && type.structure != nullptr)
      return type.structure->members[static_cast<std::size_t>(i)].type;
    return type.element();
  }

  bool may_read(const Variable& variable) const { return reserved_.count(variable.name) == 0; }

  // The ways into what a variable holds, of the type wanted. An index is `index`, kept in bounds.
  void paths(const Type& from, const std::string& text, const Type& wanted, bool as_place,
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

  std::string swizzle(int rows, int count, bool distinct) {
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

  std::string index(int count) {
    if (chance(40)) return std::to_string(below(count));
    std::vector<std::string> found;
    for (const Variable& variable : variables_)
      if (may_read(variable)) paths(variable.type, variable.name, integer, false, found, 0);
    if (found.empty()) return "0";
    const std::string chosen = one_of(found);
    if (count == 2 || count == 4) return chosen + " & " + std::to_string(count - 1);
    return "int(uint(" + chosen + ") % " + std::to_string(count) + "u)";
  }

  std::string read(const Type& type) {
    std::vector<std::string> found;
    for (const Variable& variable : variables_)
      if (may_read(variable)) paths(variable.type, variable.name, type, false, found, 2);
    if (found.empty() || chance(5)) return made(type);
    return one_of(found);
  }

  // Something of a type that no variable has.
  std::string made(const Type& type) {
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

  // A place to write of that type, whose variable may be written now; empty if there is none.
  std::string place(const Type& type, const std::set<std::string>& among) {
    std::vector<std::string> found;
    for (const Variable& variable : variables_) {
      if (!variable.writable || (!among.empty() && among.count(variable.name) == 0)) continue;
      if (among.empty() && !may_read(variable)) continue;
      paths(variable.type, variable.name, type, true, found, 3);
    }
    return found.empty() ? "" : one_of(found);
  }

  // --- Expressions --------------------------------------------------------------

  // `effects`: whether it may write the reserved variables.
  std::string expression(const Type& type, int depth, bool effects) {
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

  std::string pair(const Type& a, const char* sign, const Type& b, int depth, bool effects) {
    const bool left = chance(50);
    return expression(a, depth - 1, effects && left) + " " + sign + " " +
           expression(b, depth - 1, effects && !left);
  }

  std::string real_value(const Type& type, int depth, bool effects) {
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
        return "q(mix(" + read(type) + ", " + one() + ", " + one_of<std::string>({"0.5", "0.25", "1.0"}) +
               "))";
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

  // Arguments of a vector's constructor: smaller vectors and scalars, of any base.
  std::string joined(const Type& type, int depth, bool effects) {
    std::string text;
    const int chosen = below(3);
    for (int left = type.rows, i = 0; left > 0; ++i) {
      const int n = left == 1 ? 1 : 1 + below(std::min(left, 3));
      text += (i > 0 ? ", " : "") + expression(Type{type.base, n}, depth - 1, effects && i == chosen);
      left -= n;
    }
    return text;
  }

  std::string whole_value(const Type& type, int depth, bool effects) {
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

  std::string truth_value(const Type& type, int depth, bool effects) {
    Type of{static_cast<Base>(below(3)), type.rows};
    if (type.is_vector()) {
      if (chance(20)) return "not(" + expression(type, depth - 1, effects) + ")";
      if (chance(20)) return name_of(type) + "(" + joined(type, depth, effects) + ")";
      return one_of<std::string>({"lessThan(", "greaterThan(", "lessThanEqual(", "greaterThanEqual(",
                                  "equal(", "notEqual("}) +
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

  std::string matrix(const Type& type, int depth, bool effects) {
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

  // Writes a reserved variable and gives a value.
  std::string effect(const Type& type, int depth) {
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

  // A call that gives that type; empty if there is none.
  std::string call(const Type& type, int depth, bool effects) {
    std::vector<const Function*> found;
    for (const Function& function : functions_) {
      if (!function.returns || function.result != type || (function.writes && !effects)) continue;
      if (function.discards || cost_ + function.cost * rounds_ > 6000) continue;
      found.push_back(&function);
    }
    if (found.empty()) return {};
    return call_of(*one_of(found), depth, effects);
  }

  std::string call_of(const Function& function, int depth, bool effects) {
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

  // A whole expression, with some variables put aside for its effects.
  std::string full(const Type& type, int depth) {
    reserve();
    in_expression_ = true;
    std::string text = expression(type, depth, !reserved_.empty());
    in_expression_ = false;
    reserved_.clear();
    return text;
  }

  // Globals that a function may write are put aside whenever one may be called.
  void reserve() {
    reserved_.clear();
    if (!chance(45)) return;
    for (const Variable& variable : variables_)
      if (variable.writable && (variable.global || chance(25))) reserved_.insert(variable.name);
    for (const Variable& variable : variables_)
      if (reserved_.count(variable.name) != 0 && variable.global) writes_ = true;
  }

  // --- Statements ---------------------------------------------------------------

  void line(const std::string& text) {
    text_ += std::string(static_cast<std::size_t>(indent_) * 2, ' ') + text + "\n";
  }

  // From here on the name means this one.
  void add_local(const Type& type, const std::string& name) {
    std::erase_if(variables_, [&](const Variable& variable) { return variable.name == name; });
    variables_.push_back({type, name});
  }

  void declare(const Type& type) {
    const std::string name = fresh("v");
    std::string start = chance(75) ? " = " + full(type, 3) : "";
    if (type.count > 0 && chance(30)) {
      line(name_of(type.element()) + " " + name + "[" + std::to_string(type.count) + "]" + start + ";");
    } else if (chance(15) && type.count == 0) {
      const std::string second = fresh("v");
      line(name_of(type) + " " + name + start + ", " + second + ";");
      add_local(type, name);
      add_local(type, second);
    } else {
      const bool is_number = type.structure == nullptr && type.base != Base::truth;
      line((is_number && chance(10) ? "highp " : "") + name_of(type) + " " + name + start + ";");
    }
    add_local(type, name);
  }

  void assign() {
    for (int tries = 0; tries < 8; ++tries) {
      const Type type = chance(70) ? basic() : any();
      const std::string to = place(type, {});
      if (to.empty()) continue;
      // What the place's indices read must not be written by the value's effects.
      in_expression_ = true;
      if (chance(30)) reserve();
      for (const Variable& variable : variables_)
        if (mentions(to, variable.name)) reserved_.erase(variable.name);
      bool global_kept = true;
      for (const Variable& variable : variables_)
        if (variable.global && variable.writable && reserved_.count(variable.name) == 0) global_kept = false;
      if (!global_kept) reserved_.clear();
      const bool effects = !reserved_.empty();
      std::string value;
      const bool counts = type.count == 0 && type.structure == nullptr && type.base != Base::truth;
      if (counts && type.base != Base::real && chance(50)) {
        const std::string sign = one_of<std::string>({" += ", " -= ", " *= ", " ^= ", " |= ", " &= "});
        value = to + sign + expression(chance(50) ? type : Type{type.base}, 3, effects);
      } else if (counts && type.base == Base::real && type.columns == 1 && chance(50)) {
        value = to + " += " + expression(type, 3, effects);
        line(value + ";");
        value = to + " = q(" + to + ")";
      } else if (counts && type.base != Base::real && chance(20)) {
        value = chance(50) ? to + "++" : "--" + to;
      } else {
        value = to + " = " + expression(type, 4, effects);
      }
      in_expression_ = false;
      reserved_.clear();
      line(value + ";");
      return;
    }
  }

  static bool mentions(const std::string& text, const std::string& name) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const bool starts = at == 0 || !is_word(text[at - 1]);
      const bool ends = at + name.size() == text.size() || !is_word(text[at + name.size()]);
      if (starts && ends) return true;
    }
    return false;
  }

  // Statements between braces, with names of their own.
  template <class Body>
  void scope(const Body& body) {
    const std::vector<Variable> outer = variables_;
    const std::set<std::string> taken = taken_;
    taken_.clear();
    ++indent_;
    body();
    --indent_;
    taken_ = taken;
    variables_ = outer;
  }

  void block(int statements, int depth) {
    scope([&] {
      for (int i = 0; i < statements; ++i) statement(depth);
    });
  }

  void condition(int depth) {
    const std::string test = full(truth, 3);
    line((chance(20) ? "WHEN(" : "if (") + test + ") {");
    block(1 + below(3), depth - 1);
    if (chance(50)) {
      line("} else {");
      block(1 + below(3), depth - 1);
    }
    line("}");
  }

  void loop(int depth) {
    const int before = rounds_;
    const int turns = 2 + below(3);
    rounds_ *= turns;
    const bool outer_loop = std::exchange(in_loop_, true);
    const std::string name = "i" + std::to_string(names_++);
    const std::string count = std::to_string(turns);
    scope([&] {
      const int kind = below(5);
      variables_.push_back({integer, name, false});
      switch (kind) {
        case 0:
          line("TIMES(" + name + ", " + count + ") {");
          break;
        case 1:
          line("for (int " + name + " = " + count + "; " + name + " > 0 && " + full(truth, 2) + "; " + name +
               "--) {");
          break;
        case 2:
          line("int " + name + " = 0;");
          line("while (" + name + "++ < " + count + ") {");
          break;
        case 3:
          line("int " + name + " = 0;");
          line("do {");
          break;
        default:
          line("for (int " + name + " = 0; ; ++" + name + ") {");
          line("  if (" + name + " >= " + count + (chance(50) ? " || " + full(truth, 2) : "") + ") break;");
      }
      block(1 + below(3), depth - 1);
      if (kind == 3)
        line("} while (++" + name + " < " + count + (chance(50) ? " && " + full(truth, 2) : "") + ");");
      else
        line("}");
    });
    in_loop_ = outer_loop;
    rounds_ = before;
  }

  void choose(int depth) {
    // glslang refuses a last label with nothing but declarations behind.
    const std::string counter = "k" + std::to_string(names_++);
    line("int " + counter + " = 0;");
    line("switch (" + full(integer, 2) + " & 3) {");
    const bool outer = std::exchange(in_switch_, true);
    scope([&] {
      const int default_at = below(5);
      for (int i = 0; i < 4; ++i) {
        if (i == default_at) line("default:");
        if (i == 0 || chance(80)) line("case " + std::to_string(i) + ":");
        if (i == 3 || chance(75)) {
          line("{");
          if (i == 3) line("  ++" + counter + ";");
          block(1 + below(2), depth - 1);
          line("}");
          if (chance(60)) line("break;");
        }
      }
    });
    in_switch_ = outer;
    line("}");
  }

  void jump() {
    const std::string test = full(truth, 2);
    switch (below(6)) {
      case 0:
      case 1:
        if (in_loop_ || in_switch_) return line("if (" + test + ") break;");
        break;
      case 2:
      case 3:
        if (in_loop_) return line("if (" + test + ") continue;");
        break;
      case 4:
        if (result_ != nullptr) return line("if (" + test + ") return " + full(*result_, 2) + ";");
        return line("if (" + test + ") return;");
      default:
        if (chance(70)) break;
        discards_ = true;
        return line("if (" + test + " && (p.x + p.y > 9.0)) discard;");
    }
    line(";");
  }

  void call_statement() {
    std::vector<const Function*> found;
    for (const Function& function : functions_)
      if (cost_ + function.cost * rounds_ < 6000) found.push_back(&function);
    if (found.empty()) return;
    // Arguments are read before the function writes any global.
    const Function& chosen = *one_of(found);
    const std::string text = call_of(chosen, 3, true);
    if (text.empty()) return;
    discards_ = discards_ || chosen.discards;
    line(text + ";");
  }

  void statement(int depth) {
    cost_ += rounds_;
    const int kind = below(100);
    if (kind < 12) return declare(any());
    if (kind < 45 || depth <= 0) return assign();
    if (kind < 60) return condition(depth);
    if (kind < 70 && rounds_ < 30) return loop(depth);
    if (kind < 77) return choose(depth);
    if (kind < 87) return jump();
    if (kind < 93) return call_statement();
    assign();
  }

  void function(int number) {
    const std::vector<Variable> outer = variables_;
    taken_.clear();
    Function made;
    made.name = "f" + std::to_string(number);
    if (number > 0 && chance(25)) made.name = one_of(functions_).name;  // an overload
    made.returns = chance(80);
    made.result = chance(70) ? basic() : any();
    if (made.result.base == Base::truth && chance(50)) made.result = integer;
    const int count = 1 + below(4);
    std::string parameters = "vec2 p";
    made.types.push_back({Base::real, 2});
    made.passing.push_back(Passing::in);
    for (int i = 0; i < count; ++i) {
      const Type type = any();
      const Passing passing = static_cast<Passing>(below(4));
      static const char* const words[] = {"", "const in ", "out ", "inout "};
      const std::string name = "a" + std::to_string(i);
      parameters += std::string(", ") + words[static_cast<int>(passing)] + name_of(type) + " " + name;
      made.types.push_back(type);
      made.passing.push_back(passing);
      made.writes = made.writes || passing == Passing::out || passing == Passing::inout;
      variables_.push_back({type, name, passing != Passing::const_in});
    }
    for (const Function& other : functions_) {
      if (other.name == made.name && other.types == made.types) made.name = "f" + std::to_string(number);
    }
    variables_.push_back({{Base::real, 2}, "p", false});
    text_ += (made.returns ? name_of(made.result) : "void") + " " + made.name + "(" + parameters + ") {\n";
    result_ = made.returns ? &made.result : nullptr;
    cost_ = 0;
    rounds_ = 1;
    discards_ = false;
    indent_ = 1;
    const int statements = 3 + below(5);
    for (int i = 0; i < statements; ++i) statement(2);
    if (made.returns) line("return " + full(made.result, 3) + ";");
    text_ += "}\n";
    made.writes = true;  // it may write globals
    made.discards = discards_;
    made.cost = std::max(cost_, 1);
    variables_ = outer;
    result_ = nullptr;
    functions_.push_back(made);
  }

  // What a variable holds, as one float below 64.
  std::string folded(const Type& type, const std::string& text) {
    if (type.count > 0 || type.structure != nullptr || type.columns > 1 || type.rows > 1) {
      std::string sum;
      for (int i = 0; i < parts(type); ++i) {
        const bool is_member = type.count == 0 && type.structure != nullptr;
        const std::string inner = is_member
                                      ? text + "." + type.structure->members[static_cast<std::size_t>(i)].name
                                      : text + "[" + std::to_string(i) + "]";
        sum = sum.empty() ? folded(part(type, i), inner)
                          : "q(" + sum + " * 3.0 + " + folded(part(type, i), inner) + ")";
      }
      return sum;
    }
    switch (type.base) {
      case Base::real:
        return "q(" + text + ")";
      case Base::integer:
        return "float((" + text + " ^ (" + text + " >> 11)) & 63)";
      case Base::natural:
        return "float((" + text + " ^ (" + text + " >> 11)) & 63u)";
      default:
        return "float(" + text + ")";
    }
  }

  void main_image() {
    text_ += "void mainImage(out vec4 color, in vec2 p) {\n";
    cost_ = 0;
    rounds_ = 1;
    indent_ = 1;
    taken_.clear();
    variables_.push_back({{Base::real, 2}, "p", false});
    line("int n = int(p.x) * 7 + int(p.y) * 3 + iFrame;");
    line("uint h = uint(n) * 2654435769u;");
    line("vec4 s = q(AT(n, n >> 3) + vec4(p, p.yx) * 0.5);");
    // While all pixels run.
    line("s.x = q(s.x + dFdx(s.y) + dFdy(float(n & 15)) + fwidth(s.z));");
    for (const auto& [type, name] : std::initializer_list<std::pair<Type, const char*>>{
             {integer, "n"}, {{Base::natural}, "h"}, {{Base::real, 4}, "s"}})
      variables_.push_back({type, name});
    for (int i = 0; i < 4; ++i) declare(any());
    const int statements = 6 + below(8);
    for (int i = 0; i < statements; ++i) statement(2);
    for (int i = 0; i < 2; ++i) call_statement();
    line("color = q(s);");
    int channel = 0;
    for (const Variable& variable : variables_) {
      if (variable.name == "p") continue;
      const std::string to = std::string("color.") + "xyzw"[channel++ % 4];
      line(to + " = q(" + to + " * 5.0 + " + folded(variable.type, variable.name) + ");");
    }
    text_ += "}\n";
  }

  std::uint32_t state_;
  std::string text_;
  int indent_ = 0;
  int names_ = 0;
  std::set<std::string> taken_;
  std::vector<const Structure*> structures_;
  std::vector<Variable> variables_;
  std::vector<Function> functions_;
  std::set<std::string> reserved_;  // variables that only effects touch
  bool in_expression_ = false;
  bool in_loop_ = false;
  bool in_switch_ = false;
  bool writes_ = false;
  bool discards_ = false;
  const Type* result_ = nullptr;
  int cost_ = 0;    // statements run so far
  int rounds_ = 1;  // how often a statement runs here
};

}  // namespace

std::string random_shader(std::uint32_t seed) {
  return Writer(seed).write();
}

}  // namespace shadertwin
