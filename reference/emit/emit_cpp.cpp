#include "reference/emit/emit_cpp.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include "host/base/error.h"
#include "host/text/storage.h"
#include "reference/emit/cpp_context.h"
#include "reference/emit/cpp_function.h"
#include "reference/emit/packet_expression.h"
#include "reference/emit/packet_function.h"

namespace shadertwin {

using namespace glslang;

namespace emit {
namespace {

// Collects lines and puts #line in front of those that the one before doesn't lead to.
class CppText {
 public:
  CppText(const Project& project, const std::string& own_name) : project_(project), own_name_(own_name) {}

  void add(const std::string& line) { add({0, line, {}}); }

  void add(const CppLine& line) {
    if (line.source.file >= 0) {
      const bool follows = line.source.file == expected_.file &&
                           (line.source.line == expected_.line || line.source.line == expected_.line - 1);
      if (!follows || line.source.line != expected_.line)
        text_ += "#line " + std::to_string(line.source.line) + " \"" +
                 escaped(project_.files[line.source.file]) + "\"\n";
      expected_ = {line.source.file, line.source.line + 1};
    } else if (expected_.file >= 0) {
      // Back to this file: two lines on, because #line names the line behind itself.
      const auto lines = std::count(text_.begin(), text_.end(), '\n');
      text_ += "#line " + std::to_string(lines + 2) + " \"" + escaped(own_name_) + "\"\n";
      expected_ = {};
    }
    text_ += std::string(static_cast<std::size_t>(line.depth) * 2, ' ') + line.written() + '\n';
  }

  std::string take() { return std::move(text_); }

  // A name may hold anything: whatever is not plain is written as an octal escape, so that it can end
  // neither the string nor the line, nor begin a trigraph.
  static std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
      const auto byte = static_cast<unsigned char>(c);
      const bool plain = byte >= 0x80 || std::isalnum(byte) != 0 || std::strchr(" -_./+,:~@", c) != nullptr;
      if (plain && c != '\0') {
        text += c;
        continue;
      }
      std::array<char, 5> octal{};
      std::snprintf(octal.data(), octal.size(), "\\%03o", byte);
      text += octal.data();
    }
    return text;
  }

 private:
  const Project& project_;
  std::string own_name_;
  std::string text_;
  SourceLine expected_;
};

class CppModule {
 public:
  CppModule(const Project& project, const Program& program, const CppOptions& options,
            const std::string& own_name, const SyntaxTree* in_double = nullptr)
      : program_(program), context_(program, options, in_double), text_(project, own_name) {}

  std::string write_header(const std::string& name) {
    std::vector<CppLine> functions;
    std::vector<std::string> prototypes;
    for (const Function& function : program_.functions()) {
      FunctionScope scope;
      CppExpressions expressions(context_, scope);
      CppFunction writer(context_, function, scope, expressions);
      prototypes.push_back("inline " + writer.signature() + ";");
      const std::vector<CppLine> lines = writer.lines("inline ");
      functions.push_back({});
      functions.insert(functions.end(), lines.begin(), lines.end());
    }
    const std::vector<std::string> variables = thread_variables();

    text_.add("#pragma once");
    text_.add("#pragma GCC system_header");  // written by a program: its warnings would be nobody's
    text_.add("");
    if (context_.options().double_precision) {
      text_.add("#ifndef SHADERTWIN_DOUBLE");
      text_.add("#error \"this header is for a target with SHADERTWIN_DOUBLE\"");
      text_.add("#endif");
    }
    text_.add("#include \"reference/twin/alone.h\"");
    text_.add("");
    // Whoever includes it may have any macro.
    for (const std::string& macro : context_.used_names()) text_.add("#pragma push_macro(\"" + macro + "\")");
    for (const std::string& macro : context_.used_names()) text_.add("#undef " + macro);
    text_.add("");
    text_.add("namespace " + name + " {");
    text_.add("");
    text_.add("using namespace shadertwin::glsl;");
    for (const std::string& builtin : builtins())  // the C library has some of them in the global namespace
      text_.add("using shadertwin::glsl::" + builtin + ";");
    text_.add("");
    structs();
    for (const std::string& constant : context_.hoisted()) text_.add("inline " + constant);
    for (const std::string& variable : variables) text_.add(variable);
    text_.add("");
    for (const std::string& prototype : prototypes) text_.add(prototype);
    for (const CppLine& line : functions) text_.add(line);
    text_.add("");
    text_.add("}  // namespace " + name);
    text_.add("");
    for (const std::string& macro : context_.used_names()) text_.add("#pragma pop_macro(\"" + macro + "\")");
    return text_.take();
  }

  std::string write(const Storage& storage) {
    const bool packets = context_.options().packets;
    std::optional<Uniformity> uniformity;
    if (packets) uniformity.emplace(program_);
    std::vector<CppLine> members;
    for (const Function& function : program_.functions()) {
      for (CppLine& line : packets ? packet_lines(function, *uniformity) : single_lines(function)) {
        ++line.depth;
        members.push_back(std::move(line));
      }
      members.push_back({});
    }
    std::vector<CppLine> initialisers = packets ? packet_initialiser_lines(*uniformity) : initialiser_lines();

    const std::string space = packets ? "shadertwin::glsl::packet" : "shadertwin::glsl";
    text_.add(packets ? "#include \"reference/twin/packet_invocation.h\""
                      : "#include \"reference/twin/invocation.h\"");
    undefine_macros();
    text_.add("");
    text_.add("namespace " + space + " {");
    text_.add("namespace {");
    text_.add("");
    structs();
    for (const std::string& constant : context_.hoisted()) text_.add(constant);
    if (!context_.hoisted().empty()) text_.add("");
    text_.add("struct Shader : Invocation {");
    variables();
    text_.add(packets ? "  void initialise__(Bool " + initial_mask_ + ") {" : "  void initialise__() {");
    for (CppLine& line : initialisers) {
      line.depth += 2;
      text_.add(line);
    }
    text_.add("  }");
    bindings(storage);
    text_.add("");
    for (const CppLine& line : members) text_.add(line);
    text_.add("};");
    text_.add("");
    text_.add("}  // namespace");
    text_.add("}  // namespace " + space);
    text_.add("");
    text_.add((packets ? "SHADERTWIN_EXPORT_PACKETS(" : "SHADERTWIN_EXPORT(") + output() + ")");
    return text_.take();
  }

 private:
  // A shader may use any name that C++'s headers define as a macro. Names with an underscore in front are
  // each compiler's own, which may not be the one that made the list.
  void undefine_macros() {
    for (const std::string& name : context_.used_names())
      if (name.starts_with('_') || is_header_macro(name)) text_.add("#undef " + name);
  }

  void structs() {
    for (const StructTable::Entry& entry : context_.structs().entries()) {
      text_.add("struct " + entry.name + " {");
      const TTypeList& members = *entry.type->getStruct();
      for (std::size_t i = 0; i < members.size(); ++i)
        text_.add("  " + context_.type(*members[i].type, true) + " " +
                  context_.field(*entry.type, static_cast<int>(i)) + ";");
      if (context_.options().packets)
        packet_operations(entry);
      else
        text_.add("  bool operator==(const " + entry.name + "&) const = default;");
      text_.add("};");
      text_.add("");
    }
  }

  // Masked assignment and equality, member by member.
  void packet_operations(const StructTable::Entry& entry) {
    std::string sets;
    std::string equals = "Bool(true)";
    for (std::size_t i = 0; i < entry.type->getStruct()->size(); ++i) {
      const std::string field = context_.field(*entry.type, static_cast<int>(i));
      sets += " set__(m, to." + field + ", from." + field + ");";
      equals += " && same__(a." + field + ", b." + field + ")";
    }
    const std::string name = entry.name;
    text_.add("  friend void set__(Bool m, " + name + "& to, const " + name + "& from) {" + sets + " }");
    text_.add("  friend Bool same__(const " + name + "& a, const " + name + "& b) { return " + equals +
              "; }");
  }

  bool is_unused_uniform(const TIntermSymbol& symbol) const {
    return symbol.getQualifier().storage == EvqUniform &&
           std::none_of(
               program_.functions().begin(), program_.functions().end(),
               [&](const Function& function) { return function.globals.reads.count(symbol.getId()) != 0; });
  }

  void variables() {
    for (const TIntermSymbol* symbol : program_.globals()) {
      if (symbol->getQualifier().isConstant() || is_unused_uniform(*symbol)) continue;
      const bool varying = symbol->getQualifier().storage != EvqUniform;
      text_.add("  " + context_.type(symbol->getType(), varying) + " " + context_.global(*symbol) + "{};");
    }
    text_.add("");
  }

  std::set<std::string> builtins() const {
    std::set<std::string> names;
    for (const Function& function : program_.functions()) {
      for (const std::string& name : function.builtins) names.insert(context_.builtin(name));
    }
    return names;
  }

  std::vector<CppLine> single_lines(const Function& function) {
    FunctionScope scope;
    CppExpressions expressions(context_, scope);
    return CppFunction(context_, function, scope, expressions).lines();
  }

  std::vector<CppLine> packet_lines(const Function& function, const Uniformity& uniformity) {
    FunctionScope scope;
    Masks masks(scope);
    PacketExpressions expressions(context_, scope, masks, uniformity);
    return PacketFunction(context_, function, scope, expressions, masks, uniformity).lines();
  }

  // Globals and uniforms where there is no invocation to hold them.
  std::vector<std::string> thread_variables() {
    std::map<SymbolId, std::string> values;
    FunctionScope scope;
    CppExpressions expressions(context_, scope);
    for (const TIntermBinary* initialiser : program_.initialisers()) {
      if (const TIntermSymbol* symbol = initialiser->getLeft()->getAsSymbolNode())
        values[symbol->getId()] = expressions.self_contained(*initialiser->getRight());
    }
    std::vector<std::string> lines;
    for (const TIntermSymbol* symbol : program_.globals()) {
      if (symbol->getQualifier().isConstant() || is_unused_uniform(*symbol)) continue;
      const auto value = values.find(symbol->getId());
      lines.push_back("inline thread_local " + context_.type(symbol->getType()) + " " +
                      context_.global(*symbol) +
                      (value == values.end() ? "{};" : " = " + value->second + ";"));
    }
    return lines;
  }

  std::vector<CppLine> packet_initialiser_lines(const Uniformity& uniformity) {
    FunctionScope scope;
    Masks masks(scope);
    PacketExpressions expressions(context_, scope, masks, uniformity);
    for (const TIntermSymbol* symbol : program_.globals()) scope.names.reserve(context_.global(*symbol));
    masks.open();
    initial_mask_ = masks.current();
    return initialiser_lines(scope, expressions, initial_mask_ + ", ");
  }

  std::vector<CppLine> initialiser_lines() {
    FunctionScope scope;
    CppExpressions expressions(context_, scope);
    return initialiser_lines(scope, expressions, "");
  }

  std::vector<CppLine> initialiser_lines(FunctionScope& scope, CppExpressions& expressions,
                                         const std::string& mask) {
    std::set<SymbolId> written;
    for (const TIntermBinary* initialiser : program_.initialisers()) {
      if (const TIntermSymbol* symbol = initialiser->getLeft()->getAsSymbolNode())
        written.insert(symbol->getId());
    }
    for (const TIntermSymbol* symbol : program_.globals()) {
      const TStorageQualifier storage = symbol->getQualifier().storage;
      if (written.count(symbol->getId()) == 0 && (storage == EvqGlobal || storage == EvqVaryingOut))
        scope.out.statement("unwritten(" + mask + context_.global(*symbol) + ")");
    }
    for (const TIntermBinary* initialiser : program_.initialisers()) expressions.statement(*initialiser);
    return scope.out.take();
  }

  void bindings(const Storage& storage) {
    text_.add("  template <class Bind>");
    text_.add("  void bind_uniforms__(Bind&& bind) {");
    for (const TIntermSymbol* symbol : program_.globals()) {
      // No host has a structure to give.
      if (symbol->getQualifier().storage == EvqUniform && !is_unused_uniform(*symbol) &&
          !symbol->getType().isStruct())
        text_.add(std::string("    bind(\"") + symbol->getName().c_str() + "\", " + context_.global(*symbol) +
                  ");");
    }
    text_.add("  }");
    text_.add(std::string("  static constexpr bool uses_derivatives__ = ") +
              (program_.uses_derivatives() ? "true" : "false") + ";");
    text_.add(std::string("  static constexpr bool uses_implicit_lod__ = ") +
              (program_.uses_implicit_lod() ? "true" : "false") + ";");
    // Packets discard by their mask.
    const bool stops = (program_.uses_discard() && !context_.options().packets) ||
                       context_.options().loop_guards || context_.options().checks ||
                       context_.options().shadows;
    text_.add(std::string("  static constexpr bool uses_stop__ = ") + (stops ? "true" : "false") + ";");
    text_.add("  static constexpr std::size_t components__ = " +
              std::to_string(storage.variables + storage.temporaries) + ";");
    if (context_.options().shadows) places();
  }

  void places() {
    text_.add("  static constexpr shadertwin::twin::PlaceName places__[] = {");
    for (const Places::Place& place : context_.places().all())
      text_.add("    {" + std::to_string(place.at.file) + ", " + std::to_string(place.at.line) + ", \"" +
                CppText::escaped(place.text) + "\"},");
    text_.add("  };");
  }

  // The variable that holds the pixel: the output at location 0, or the only one.
  std::string output() {
    const TIntermSymbol* found = nullptr;
    for (const TIntermSymbol* symbol : program_.globals()) {
      if (symbol->getQualifier().storage != EvqVaryingOut) continue;
      const bool first = !symbol->getQualifier().hasLocation() || symbol->getQualifier().layoutLocation == 0;
      if (found == nullptr || first) found = symbol;
    }
    if (found == nullptr) throw Error(ExitStatus::shader, "error: the shader has no output");
    return context_.global(*found);
  }

  const Program& program_;
  CppContext context_;
  CppText text_;
  std::string initial_mask_;  // the name of the mask under which packets initialise globals
};

}  // namespace
}  // namespace emit

std::string emit_cpp(const Project& project, const Pass& pass, const CppOptions& options) {
  const SyntaxTree tree(project, pass.source, options.double_precision ? Folding::float64 : Folding::float32);
  const Storage storage = measure_allowed_storage(tree);
  const emit::Program program(tree);
  std::optional<SyntaxTree> in_double;
  if (options.shadows) in_double.emplace(project, pass.source, Folding::float64);
  return emit::CppModule(project, program, options, "twin.cpp", in_double ? &*in_double : nullptr)
      .write(storage);
}

std::string emit_header(const Project& project, const Pass& pass, const std::string& name,
                        const CppOptions& options) {
  CppOptions header = options;
  header.initialise_locals = true;
  const SyntaxTree tree(project, pass.source, header.double_precision ? Folding::float64 : Folding::float32);
  const emit::Program program(tree);
  return emit::CppModule(project, program, header, name + ".h").write_header(name);
}

}  // namespace shadertwin
