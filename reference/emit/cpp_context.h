// What all functions of one C++ twin share: names, types and constants.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "reference/emit/emit_cpp.h"
#include "reference/emit/expression.h"
#include "reference/emit/names.h"
#include "reference/emit/places.h"
#include "reference/emit/program.h"

namespace shadertwin::emit {

// Structures of a shader, each once, those that others hold first.
class StructTable {
 public:
  struct Entry {
    const glslang::TType* type = nullptr;
    std::string name;
    std::vector<std::string> fields;
  };

  explicit StructTable(const Program& program);
  const std::vector<Entry>& entries() const { return entries_; }
  const Entry& entry(const glslang::TType& type) const;

 private:
  void add(const glslang::TType& type);
  int find(const glslang::TType& type) const;

  std::vector<Entry> entries_;
  NameScope names_;
};

class CppContext {
 public:
  // `in_double`: the same text with constants folded in double, for twins with shadows.
  CppContext(const Program& program, const CppOptions& options, const SyntaxTree* in_double = nullptr);

  const Program& program() const { return program_; }
  const CppOptions& options() const { return options_; }
  const StructTable& structs() const { return structs_; }
  Places& places() { return places_; }

  // `vec3`, `Ray`, `array<Float, 4>` ... Where pixels run in packets, `varying` tells whether the value may
  // differ between them: `Float` and `vec3`, or `float` and `uniform::vec3`.
  std::string type(const glslang::TType& type, bool varying = false) const;
  std::string literal(double value) const { return literal(value, value); }
  std::string global(const glslang::TIntermSymbol& symbol) const;
  std::string function(const std::string& glsl_name) const;
  std::string builtin(const std::string& glsl_name) const;
  std::string field(const glslang::TType& structure, int index) const;

  // A constant's value, or the name of the hoisted constant that holds it. `varying`: as one of packets.
  Expression constant(const glslang::TIntermConstantUnion& node, bool varying = false);
  // A constant's value, written out.
  std::string value(const glslang::TType& type, const glslang::TConstUnionArray& values, int& at,
                    bool varying = false) const;
  // The name of a parameter or local variable.
  std::string local(const glslang::TIntermSymbol& symbol);
  // All names of the shader's that have been asked for. A header that the twin includes may define them as
  // macros.
  const std::set<std::string>& used_names() const { return used_names_; }
  // Declarations of the constants that constant() has hoisted, in the order of their first use.
  const std::vector<std::string>& hoisted() const { return hoisted_; }

 private:
  bool is_finite(double value) const;
  // `exact`: the same in double.
  std::string literal(double value, double exact) const;
  Expression scalar(const glslang::TConstUnion& number, double exact) const;
  // A number of the constant that is being written, in double.
  double exact(const glslang::TConstUnionArray& values, int at) const;
  std::string named_constant(const glslang::TIntermConstantUnion& node);
  bool is_global_constant(const std::string& name, const glslang::TIntermConstantUnion& node) const;
  std::string hoist(const std::string& wanted_name, const std::string& type, const std::string& value);

  const Program& program_;
  CppOptions options_;
  StructTable structs_;
  Places places_;
  NameScope names_;
  std::map<SymbolId, std::string> globals_;
  std::map<std::string, std::string> functions_;
  std::map<std::string, const glslang::TIntermSymbol*> constants_;  // of the global scope
  std::map<std::string, std::string> hoisted_names_;                // by wanted name and value
  std::vector<std::string> hoisted_;
  std::set<std::string> used_names_;
  std::multimap<int, const glslang::TIntermConstantUnion*> in_double_;  // by token
  const glslang::TConstUnionArray* exact_values_ = nullptr;  // of the constant that is being written
};

// Whether packets hold a constant of this type as one of varying values. Structures have no other shape, and
// a lone bool is no 32-bit word.
bool is_wide_constant(const glslang::TType& type);

}  // namespace shadertwin::emit
