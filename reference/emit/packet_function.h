// GLSL functions as C++ functions over packets: where all pixels agree on the way, the scalar twin's
// statements; where they may not, statements under masks (masks.h).
#pragma once

#include <string>

#include "reference/emit/cpp_function.h"
#include "reference/emit/masks.h"
#include "reference/emit/uniformity.h"

namespace shadertwin::emit {

class PacketFunction : public CppFunction {
 public:
  PacketFunction(CppContext& context, const Function& function, FunctionScope& scope,
                 CppExpressions& expressions, Masks& masks, const Uniformity& uniformity);

 private:
  bool varies(const glslang::TIntermSymbol& symbol) const override { return uniformity_.varies(symbol); }
  std::string result_type() const override;
  std::string first_parameter() const override { return "Bool " + masks_.of_function(); }
  void begin() override;
  void end() override;
  void jump(const glslang::TIntermBranch& node) override;
  void control(const TIntermNode& node, const Block* wrapper) override;
  void loop_body(const glslang::TIntermLoop& node) override;
  void reset_out_parameter(const std::string& name) override;
  void after(const TIntermNode& statement) override;

  void divergent_selection(const glslang::TIntermSelection& node);
  void divergent_switch(const glslang::TIntermSwitch& node);
  void divergent_loop(const glslang::TIntermLoop& node, const Block* wrapper);
  void return_value(const glslang::TIntermBranch& node);
  // `return`, with the value that pixels have returned so far.
  std::string return_result(const std::string& otherwise) const;

  Masks& masks_;
  const Uniformity& uniformity_;
  std::string result_;  // holds what pixels return one by one; empty if they return together
};

}  // namespace shadertwin::emit
