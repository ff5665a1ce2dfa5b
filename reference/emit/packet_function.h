// GLSL functions as C++ functions over packets.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/cpp_function.h"
#include "reference/emit/packet_expression.h"
#include "reference/emit/uniformity.h"

namespace shadertwin::emit {

// Where control parts, each side runs under a mask of its own, and is skipped when that is empty:
//
//   if (Bool active_2 = active && (x < 0.0f); some__(active_2)) {
//     set__(active_2, color, vec3(1.0f, 0.0f, 0.0f));
//   }
//
// A loop that pixels leave one by one turns until its mask is empty. Where all pixels agree, the code is the
// scalar twin's.
class PacketFunction : public CppFunction {
 public:
  PacketFunction(CppContext& context, const Function& function, const Uniformity& uniformity);

 private:
  // What a jump may leave.
  struct Frame {
    enum class Kind { function, branch, loop, choice } kind;
    std::string leaving;        // the mask that a `break` leaves too; empty if all pixels leave together
    std::size_t masks = 0;      // how many masks were in use outside
    bool can_continue = false;  // C++'s own continue leads to the next round
  };

  bool varies(const glslang::TIntermSymbol& symbol) const override { return uniformity_.varies(symbol); }
  std::string result_type() const override;
  std::string first_parameter() const override { return "Bool " + mask_; }
  void begin() override;
  void end() override;
  void branch(const glslang::TIntermBranch& node) override;
  void selection(const glslang::TIntermSelection& node) override;
  void switch_statement(const glslang::TIntermSwitch& node) override;
  void for_loop(const Block& wrapper) override;
  void loop(const glslang::TIntermLoop& node, const std::string& initialiser) override;
  void reset_out_parameter(const std::string& name) override;
  void after(const TIntermNode& statement) override;

  void parting_loop(const glslang::TIntermLoop& node, const Block* wrapper);
  void body(const glslang::TIntermLoop& node, const std::string& loop_mask, bool own_mask, bool can_continue);
  void return_value(const glslang::TIntermBranch& node);
  // `leave__(active_3, active_2, active);`: the masks from the innermost to number `first`, and `also`.
  void leave(std::size_t first, const std::string& also = {});
  template <class Body>
  void within(const std::string& mask, const Frame& frame, const Body& body);
  std::vector<std::string>& masks() { return packets_->masks(); }

  const Uniformity& uniformity_;
  PacketExpressions* packets_;  // the same as expressions_
  std::string mask_;
  std::string result_;
  std::vector<Frame> frames_;
};

}  // namespace shadertwin::emit
