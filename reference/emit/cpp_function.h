// GLSL functions as C++ functions.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/cpp_context.h"
#include "reference/emit/cpp_expression.h"
#include "reference/emit/placement.h"

namespace shadertwin::emit {

// A line of C++, and the user's line that it stands for (file -1: none).
struct CppLine {
  int depth = 0;
  std::string text;
  SourceLine source;
};

class CppFunction {
 public:
  CppFunction(CppContext& context, const Function& function);

  // `vec3 shade(const Ray& ray, Float t)`
  std::string signature();
  std::vector<CppLine> lines();

 private:
  void block(const Block& block);
  void scoped(const TIntermNode* node);
  void statement(const TIntermNode* node);
  void expression_statement(const glslang::TIntermTyped& node);
  void initialise(const glslang::TIntermSymbol& symbol, const glslang::TIntermTyped& value);
  void branch(const glslang::TIntermBranch& node);
  void selection(const glslang::TIntermSelection& node);
  void switch_statement(const glslang::TIntermSwitch& node);
  void loop(const glslang::TIntermLoop& node, const std::string& initialiser);
  bool is_for_loop(const Block& block) const;
  void for_loop(const Block& wrapper);
  void declare(const Block& block, int index);
  void declare(const glslang::TIntermSymbol& symbol);
  std::string take_name(const glslang::TIntermSymbol& symbol);
  bool is_pending(const glslang::TIntermSymbol& symbol) const;
  void reset_out_parameters();
  void at(const TIntermNode& node);
  void line(const std::string& text);
  void prelude();
  // For a twin that checks: where it is, and the value that `left` has got.
  std::string mark() const;
  void watch(const glslang::TIntermTyped& left);
  void watch(const glslang::TType& type, const std::string& text);

  CppContext& context_;
  const Function& function_;
  Placement placement_;
  NameScope names_;
  CppExpressions expressions_;
  std::vector<std::string> parameter_names_;
  std::vector<const glslang::TIntermSymbol*> pending_;  // to be declared by their first assignment
  std::vector<std::string> block_names_;                // to give back at the end of the block
  std::vector<CppLine> lines_;
  int depth_ = 0;
  SourceLine source_;
};

}  // namespace shadertwin::emit
