#include "host/text/declarations.h"

#include <map>
#include <set>

namespace shadertwin {
namespace {

std::set<std::string> builtin_types() {
  std::set<std::string> types = {"void", "float", "int", "uint", "bool"};
  for (const std::string n : {"2", "3", "4"}) {
    for (const std::string prefix : {"vec", "ivec", "uvec", "bvec", "mat"}) types.insert(prefix + n);
    for (const std::string m : {"2", "3", "4"}) types.insert("mat" + n + "x" + m);
  }
  for (const std::string prefix : {"", "i", "u"}) {
    for (const std::string kind : {"2D", "3D", "Cube", "2DArray"}) types.insert(prefix + "sampler" + kind);
  }
  types.insert({"sampler2DShadow", "samplerCubeShadow", "sampler2DArrayShadow"});
  return types;
}

const std::set<std::string> qualifiers = {"const",   "in",      "out",      "inout",  "highp",
                                          "mediump", "lowp",    "flat",     "smooth", "centroid",
                                          "uniform", "precise", "invariant"};

// Walks the tokens by the grammar of declarations and statements; expressions are only searched for names.
class Scanner {
 public:
  Scanner(const std::vector<PlainToken>& tokens, std::vector<int>& declaration, std::vector<bool>& is_const,
          std::vector<Variable>& variables, std::vector<FunctionBody>& functions, std::vector<ForLoop>& loops)
      : tokens_(tokens),
        declaration_(declaration),
        is_const_(is_const),
        variables_(variables),
        functions_(functions),
        loops_(loops),
        types_(builtin_types()) {}

  void scan() {
    open_scope();
    while (at_ < size()) global();
  }

 private:
  using Scope = std::map<std::string, int>;

  int size() const { return static_cast<int>(tokens_.size()); }
  const std::string& text(int token) const {
    static const std::string end;
    return token < size() ? tokens_[token].text : end;
  }
  bool next_is(const char* expected) const { return text(at_) == expected; }
  bool accept(const char* expected) {
    if (!next_is(expected)) return false;
    ++at_;
    return true;
  }

  void open_scope() { scopes_.emplace_back(); }
  void close_scope() { scopes_.pop_back(); }

  void declare(int token, bool constant) {
    declaration_[token] = token;
    is_const_[token] = constant;
    scopes_.back()[text(token)] = token;
  }

  void resolve(int token) {
    if (!is_identifier(text(token)) || (token > 0 && text(token - 1) == ".")) return;
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      if (const auto found = scope->find(text(token)); found != scope->end()) {
        declaration_[token] = found->second;
        return;
      }
    }
  }

  // Consumes one token of an expression, or a whole bracketed part of it.
  void expression_part() {
    int depth = 0;
    do {
      const std::string& t = text(at_);
      if (t == "(" || t == "[" || t == "{") ++depth;
      if (t == ")" || t == "]" || t == "}") --depth;
      resolve(at_++);
    } while (depth > 0 && at_ < size());
  }

  bool at_end_of_expression(bool comma_ends) const {
    const std::string& t = text(at_);
    return at_ >= size() || t == ";" || t == ")" || t == "}" || (comma_ends && t == ",");
  }

  void expression(bool comma_ends) {
    while (!at_end_of_expression(comma_ends)) expression_part();
  }

  void skip_brackets() {
    while (next_is("[")) expression_part();
  }

  // Whether a declaration begins here; leaves at_ where it was.
  bool at_declaration() {
    int look = at_;
    while (qualifiers.count(text(look)) != 0) ++look;
    if (look > at_ || text(look) == "struct") return true;
    if (types_.count(text(look)) == 0 && structs_.count(text(look)) == 0) return false;
    const int after = look + 1;
    if (is_identifier(text(after))) return true;
    if (text(after) != "[") return false;
    int depth = 0;  // float[2](1.0, 2.0) is an expression, float[2] a; is not
    int token = after;
    for (; token < size(); ++token) {
      if (text(token) == "[") ++depth;
      if (text(token) == "]" && --depth == 0 && text(token + 1) != "[") break;
    }
    return is_identifier(text(token + 1));
  }

  void struct_specifier() {
    ++at_;
    if (is_identifier(text(at_))) structs_.insert(text(at_++));
    int depth = 0;
    do {
      if (next_is("{")) ++depth;
      if (next_is("}")) --depth;
      if (text(at_ - 1) == "[") resolve(at_);  // members are no variables, but their sizes name some
      ++at_;
    } while (depth > 0 && at_ < size());
  }

  // Consumes qualifiers and type: what the variables of one declaration have in common.
  Variable type() {
    Variable common;
    while (qualifiers.count(text(at_)) != 0 || next_is("layout")) {
      const std::string& qualifier = text(at_++);
      common.is_const |= qualifier == "const";
      common.is_in |= qualifier == "in" || qualifier == "inout";
      common.is_out |= qualifier == "out" || qualifier == "inout";
      common.is_uniform |= qualifier == "uniform";
      if (qualifier == "layout") expression_part();
    }
    common.type = at_;
    if (next_is("struct")) {
      struct_specifier();
    } else {
      ++at_;
    }
    skip_brackets();
    common.type_end = at_;
    common.place = scopes_.size() > 1 ? Variable::Place::local : Variable::Place::global;
    return common;
  }

  void declarators(Variable variable) {
    while (is_identifier(text(at_))) {
      variable.name = at_++;
      skip_brackets();
      variable.end = at_;
      // A name is visible after its initialiser: `float x = x;` reads the outer x.
      variable.initialised = accept("=");
      if (variable.initialised) expression(true);
      declare(variable.name, variable.is_const);
      variables_.push_back(variable);
      if (!accept(",")) break;
    }
  }

  void simple_statement() {
    if (at_declaration()) {
      declarators(type());
    } else {
      expression(false);
    }
    accept(";");
  }

  void condition() {
    if (!accept("(")) return;
    simple_statement();
    accept(")");
  }

  void statement() {
    const std::string& t = text(at_);
    if (t == "{") {
      open_scope();
      block();
      close_scope();
    } else if (t == "for") {
      open_scope();
      ForLoop loop;
      loop.open = ++at_;
      accept("(");
      simple_statement();
      simple_statement();
      expression(false);
      loop.close = at_;
      accept(")");
      statement();
      loop.end = at_;
      loops_.push_back(loop);
      close_scope();
    } else if (t == "if" || t == "while" || t == "switch") {
      const bool is_if = t == "if";
      open_scope();
      ++at_;
      condition();
      scoped_statement();
      if (is_if && accept("else")) scoped_statement();
      close_scope();
    } else if (t == "do") {
      ++at_;
      scoped_statement();
      accept("while");
      condition();
      accept(";");
    } else if (t == "case" || t == "default") {
      while (at_ < size() && !next_is(":")) resolve(at_++);
      ++at_;
    } else if (t == "return" || t == "break" || t == "continue" || t == "discard") {
      ++at_;
      expression(false);
      accept(";");
    } else {
      const int before = at_;
      simple_statement();
      if (at_ == before) ++at_;
    }
  }

  void scoped_statement() {
    open_scope();
    statement();
    close_scope();
  }

  // Returns where the last statement began.
  int block() {
    int last = ++at_;
    while (at_ < size() && !next_is("}")) {
      last = at_;
      statement();
    }
    ++at_;
    return last;
  }

  void parameters() {
    ++at_;
    while (at_ < size() && !next_is(")")) {
      Variable parameter = type();
      parameter.place = Variable::Place::parameter;
      if (is_identifier(text(at_))) {
        parameter.name = at_;
        declare(at_, parameter.is_const);
        ++at_;
      }
      skip_brackets();
      parameter.end = at_;
      variables_.push_back(parameter);
      accept(",");
    }
    ++at_;
  }

  void global() {
    const std::string& t = text(at_);
    if (t == "precision") {
      while (at_ < size() && !accept(";")) ++at_;
      return;
    }
    if (t == ";" || t[0] == '#') {
      ++at_;
      return;
    }
    const Variable common = type();
    if (is_identifier(text(at_)) && text(at_ + 1) == "(") {
      FunctionBody function;
      function.type = common.type;
      function.type_end = common.type_end;
      function.name = at_++;
      function.first_parameter = variables_.size();
      open_scope();
      parameters();
      function.parameters = variables_.size() - function.first_parameter;
      if (next_is("{")) {
        function.open = at_;
        function.returns_last = text(block()) == "return";
        function.close = at_ - 1;
        // Where the text ends before its brace does, the function has no end to write anything at.
        if (function.close < size()) functions_.push_back(function);
      }
      close_scope();
    } else {
      declarators(common);
    }
    accept(";");
  }

  const std::vector<PlainToken>& tokens_;
  std::vector<int>& declaration_;
  std::vector<bool>& is_const_;
  std::vector<Variable>& variables_;
  std::vector<FunctionBody>& functions_;
  std::vector<ForLoop>& loops_;
  std::set<std::string> types_;
  std::set<std::string> structs_;
  std::vector<Scope> scopes_;
  int at_ = 0;
};

}  // namespace

Declarations::Declarations(const std::vector<PlainToken>& tokens)
    : declaration_(tokens.size(), -1), is_const_(tokens.size(), false) {
  Scanner(tokens, declaration_, is_const_, variables_, functions_, loops_).scan();
}

}  // namespace shadertwin
