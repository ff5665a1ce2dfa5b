// GLSL functions as C++ functions.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference/emit/cpp_context.h"
#include "reference/emit/cpp_expression.h"
#include "reference/emit/function_scope.h"
#include "reference/emit/placement.h"

namespace shadertwin::emit {

class CppFunction {
 public:
  CppFunction(CppContext& context, const Function& function, FunctionScope& scope,
              CppExpressions& expressions);
  virtual ~CppFunction() = default;
  CppFunction(const CppFunction&) = delete;
  CppFunction& operator=(const CppFunction&) = delete;

  // `vec3 shade(const Ray& ray, Float t)`
  std::string signature();
  // The definition; `specifier` stands in front of it: `inline `.
  std::vector<CppLine> lines(const std::string& specifier = {});

 protected:
  // What packets (packet_function.h) say in another way.
  // Whether a variable may differ between the pixels of a packet.
  virtual bool varies(const glslang::TIntermSymbol& /*symbol*/) const { return false; }
  virtual std::string result_type() const;
  virtual std::string first_parameter() const { return {}; }
  virtual void begin() {}
  virtual void end();
  // discard, break, continue and return.
  virtual void jump(const glslang::TIntermBranch& node);
  // A selection, switch or loop. `wrapper`: what stands in front of a for loop, null if nothing does.
  virtual void control(const TIntermNode& node, const Block* wrapper);
  virtual void loop_body(const glslang::TIntermLoop& node);
  virtual void reset_out_parameter(const std::string& name);
  // Behind each statement of a block.
  virtual void after(const TIntermNode& /*statement*/) {}

  void block(const Block& block);
  // The statements of a block that is open already.
  void statements(const TIntermNode* node);
  void statement(const TIntermNode* node);
  void declare_loop_variables(const Block& wrapper);
  void begin_round();
  bool ends_with_jump() const;
  // The variables that `write` declares end behind it.
  template <class Write>
  void with_own_names(const Write& write);
  // A name for as long as the block that is being written.
  std::string take_block_name(const std::string& wanted);

  CppContext& context_;
  const Function& function_;
  CppExpressions& expressions_;
  CppWriter& out_;
  NameScope& names_;

 private:
  void selection(const glslang::TIntermSelection& node);
  void switch_statement(const glslang::TIntermSwitch& node);
  void loop(const glslang::TIntermLoop& node, const Block* wrapper);
  void loop(const glslang::TIntermLoop& node, const std::string& initialiser);
  void statement_or_list(const TIntermNode& node);
  void expression_statement(const glslang::TIntermTyped& node);
  void initialise(const glslang::TIntermSymbol& symbol, const glslang::TIntermTyped& value);
  void declare(const Block& block, int index);
  void declare(const glslang::TIntermSymbol& symbol);
  std::string take_name(const glslang::TIntermSymbol& symbol);
  void reset_out_parameters();
  void at(const TIntermNode& node);
  // For a twin that checks or has shadows: where it is, and the value that `left` has got.
  bool watches(const glslang::TType& type) const;
  // What stands in front of a watched value: the place of the line, in a twin with shadows.
  std::string watch_arguments();
  std::string mark() const;
  void watch(const glslang::TIntermTyped& left);
  void watch(const glslang::TType& type, const std::string& text);

  FunctionScope& scope_;
  Placement placement_;
  std::vector<std::string> parameter_names_;
  std::set<SymbolId> pending_;            // to be declared by their first assignment
  std::vector<std::string> block_names_;  // to give back at the end of the block
};

template <class Write>
void CppFunction::with_own_names(const Write& write) {
  const std::vector<std::string> outer = std::exchange(block_names_, {});
  write();
  for (const std::string& name : block_names_) names_.give_back(name);
  block_names_ = outer;
}

}  // namespace shadertwin::emit
