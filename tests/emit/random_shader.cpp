#include "tests/emit/random_shader.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

#include "tests/emit/random_expressions.h"

namespace shadertwin {
namespace {

using namespace random_program;

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

class Writer : RandomExpressions {
 public:
  explicit Writer(std::uint32_t seed) : RandomExpressions(seed) {}

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
  // --- Declarations -------------------------------------------------------------

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

  std::string text_;
  int indent_ = 0;
  bool in_loop_ = false;
  bool in_switch_ = false;
  bool discards_ = false;
  const Type* result_ = nullptr;
};

}  // namespace

std::string random_shader(std::uint32_t seed) {
  return Writer(seed).write();
}

}  // namespace shadertwin
