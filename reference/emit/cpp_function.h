// GLSL functions as C++ functions.
#pragma once

#include <functional>
#include <memory>
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
  virtual ~CppFunction() = default;
  CppFunction(const CppFunction&) = delete;
  CppFunction& operator=(const CppFunction&) = delete;

  // `vec3 shade(const Ray& ray, Float t)`
  std::string signature();
  std::vector<CppLine> lines();

 protected:
  CppFunction(CppContext& context, const Function& function,
              const std::function<std::unique_ptr<CppExpressions>(NameScope&)>& make_expressions);

  // What packets (packet_function.h) say in another way.
  // Whether a variable may differ between the pixels of a packet.
  virtual bool varies(const glslang::TIntermSymbol& /*symbol*/) const { return false; }
  virtual std::string result_type() const;
  virtual std::string first_parameter() const { return {}; }
  virtual void begin() {}
  virtual void end();
  virtual void branch(const glslang::TIntermBranch& node);
  virtual void selection(const glslang::TIntermSelection& node);
  virtual void switch_statement(const glslang::TIntermSwitch& node);
  virtual void for_loop(const Block& wrapper);
  virtual void loop(const glslang::TIntermLoop& node, const std::string& initialiser);
  virtual void reset_out_parameter(const std::string& name);
  // Behind each statement of a block.
  virtual void after(const TIntermNode& /*statement*/) {}

  void block(const Block& block);
  void scoped(const TIntermNode* node);
  void statement(const TIntermNode* node);
  void expression_statement(const glslang::TIntermTyped& node);
  void initialise(const glslang::TIntermSymbol& symbol, const glslang::TIntermTyped& value);
  // What stands in front of a for loop.
  void declare_loop_variables(const Block& wrapper);
  void declare(const Block& block, int index);
  void declare(const glslang::TIntermSymbol& symbol);
  std::string take_name(const glslang::TIntermSymbol& symbol);
  bool is_pending(const glslang::TIntermSymbol& symbol) const;
  void reset_out_parameters();
  bool ends_with_jump() const;
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
  std::unique_ptr<CppExpressions> expressions_;
  std::vector<std::string> parameter_names_;
  std::vector<const glslang::TIntermSymbol*> pending_;  // to be declared by their first assignment
  std::vector<std::string> block_names_;                // to give back at the end of the block
  std::vector<CppLine> lines_;
  int depth_ = 0;
  SourceLine source_;
};

}  // namespace shadertwin::emit
