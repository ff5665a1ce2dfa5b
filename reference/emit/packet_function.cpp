#include "reference/emit/packet_function.h"

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

PacketFunction::PacketFunction(CppContext& context, const Function& function, const Uniformity& uniformity)
    : CppFunction(
          context, function,
          [&](NameScope& names) { return std::make_unique<PacketExpressions>(context, names, uniformity); }),
      uniformity_(uniformity),
      packets_(static_cast<PacketExpressions*>(expressions_.get())) {
  mask_ = names_.take("active");
  masks().push_back(mask_);
  frames_.push_back({Frame::Kind::function, "", 0, false});
}

std::string PacketFunction::result_type() const {
  return context_.type(function_.definition->getType(), uniformity_.varies(function_));
}

void PacketFunction::begin() {
  if (!uniformity_.parts_at_return(function_) || function_.definition->getBasicType() == EbtVoid) return;
  result_ = names_.take("result");
  line(result_type() + " " + result_ + "{};");
}

void PacketFunction::end() {
  if (result_.empty())
    CppFunction::end();
  else if (!ends_with_jump())
    line("return " + result_ + ";");
}

void PacketFunction::reset_out_parameter(const std::string& name) {
  line("unwritten(" + mask_ + ", " + name + ");");
}

template <class Body>
void PacketFunction::within(const std::string& mask, const Frame& frame, const Body& body) {
  frames_.push_back(frame);
  if (!mask.empty()) masks().push_back(mask);
  body();
  if (!mask.empty()) masks().pop_back();
  frames_.pop_back();
}

void PacketFunction::leave(std::size_t first, const std::string& also) {
  std::string text;
  for (std::size_t i = masks().size(); i-- > first;) text += (text.empty() ? "" : ", ") + masks()[i];
  if (!also.empty()) text += ", " + also;
  line("leave__(" + text + ");");
}

void PacketFunction::return_value(const TIntermBranch& node) {
  const bool is_root = masks().size() == 1;
  if (node.getExpression() != nullptr) {
    const std::string text = packets_->value(*node.getExpression(), uniformity_.varies(function_));
    prelude();
    if (result_.empty()) return line("return " + text + ";");
    line("set__(" + packets_->mask() + ", " + result_ + ", " + text + ");");
  }
  if (is_root || !uniformity_.parts_at_return(function_))
    return line(result_.empty() ? "return;" : "return " + result_ + ";");
  leave(0);
}

void PacketFunction::branch(const TIntermBranch& node) {
  const TOperator op = node.getFlowOp();
  if (op == EOpReturn) return return_value(node);
  if (op == EOpKill) {
    line("alive__ = alive__ && !" + packets_->mask() + ";");
    return leave(0);
  }
  if (op != EOpBreak && op != EOpContinue) return CppFunction::branch(node);
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    const bool is_target =
        frame->kind == Frame::Kind::loop || (op == EOpBreak && frame->kind == Frame::Kind::choice);
    if (!is_target) continue;
    if (op == EOpBreak && frame->kind == Frame::Kind::loop) {
      if (frame->leaving.empty()) return line("break;");
      return leave(frame->masks, frame->leaving);
    }
    // All that run leave the body: its own mask, if it has one, says so, or C++ does.
    if (masks().size() == frame->masks) return line("continue;");
    return leave(frame->masks);
  }
}

void PacketFunction::selection(const TIntermSelection& node) {
  if (!uniformity_.parts(node)) return CppFunction::selection(node);
  std::string condition = packets_->value(*node.getCondition());
  prelude();
  if (node.getFalseBlock() != nullptr) {
    const std::string name = names_.take("condition");
    block_names_.push_back(name);
    line("const Bool " + name + " = " + condition + ";");
    condition = name;
  }
  const auto side = [&](const TIntermNode* statements, const std::string& holds) {
    if (statements == nullptr) return;
    const std::string inner = names_.take("active");
    line("if (Bool " + inner + " = " + packets_->mask() + " && " + holds + "; some__(" + inner + ")) {");
    within(inner, {Frame::Kind::branch, "", masks().size(), false}, [&] { scoped(statements); });
    line("}");
    names_.give_back(inner);
  };
  const bool is_plain = condition.find(' ') == std::string::npos;
  side(node.getTrueBlock(), is_plain ? condition : "(" + condition + ")");
  side(node.getFalseBlock(), "!" + condition);
}

// Each group of statements runs under the mask of the pixels whose value has led to it or that have fallen
// through.
void PacketFunction::switch_statement(const TIntermSwitch& node) {
  const TIntermTyped& selector = *node.getCondition()->getAsTyped();
  const std::string value = packets_->value(selector);
  prelude();
  line("{");
  ++depth_;
  const std::string chosen = names_.take("selector");
  const std::string inner = names_.take("active");
  line("const " + context_.type(selector.getType(), uniformity_.varies(selector)) + " " + chosen + " = " +
       value + ";");
  line("Bool " + inner + " = false;");

  std::string all_labels;
  const auto equals = [&](const TIntermBranch& label) {
    return chosen + " == " + packets_->value(*label.getExpression());
  };
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    const TIntermBranch* label = part != nullptr ? part->getAsBranchNode() : nullptr;
    if (label != nullptr && label->getFlowOp() == EOpCase)
      all_labels += (all_labels.empty() ? "" : " || ") + equals(*label);
  }
  std::string labels;
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    if (part == nullptr) continue;
    const TIntermBranch* label = part->getAsBranchNode();
    if (label != nullptr && label->getFlowOp() == EOpCase) {
      labels += (labels.empty() ? "" : " || ") + equals(*label);
      continue;
    }
    if (label != nullptr && label->getFlowOp() == EOpDefault) {
      const std::string others = all_labels.empty() ? "true" : "!(" + all_labels + ")";
      labels += (labels.empty() ? "" : " || ") + others;
      continue;
    }
    if (!labels.empty()) line(inner + " = " + inner + " || (" + packets_->mask() + " && (" + labels + "));");
    labels.clear();
    line("if (some__(" + inner + ")) {");
    within(inner, {Frame::Kind::choice, "", masks().size(), false}, [&] { scoped(part); });
    line("}");
  }
  names_.give_back(inner);
  names_.give_back(chosen);
  --depth_;
  line("}");
}

void PacketFunction::for_loop(const Block& wrapper) {
  const TIntermLoop& node = *wrapper.getSequence().back()->getAsLoopNode();
  if (uniformity_.parts(node))
    parting_loop(node, &wrapper);
  else
    CppFunction::for_loop(wrapper);
}

void PacketFunction::body(const TIntermLoop& node, const std::string& loop_mask, bool own_mask,
                          bool can_continue) {
  if (context_.options().loop_guards) line("  loop_guard();");
  std::string inner;
  const std::size_t outside = masks().size();
  if (own_mask) {
    inner = names_.take("active");
    ++depth_;
    line("Bool " + inner + " = " + packets_->mask() + ";");
    --depth_;
  }
  within(inner, {Frame::Kind::loop, loop_mask, outside, can_continue}, [&] { scoped(node.getBody()); });
  if (own_mask) names_.give_back(inner);
}

void PacketFunction::loop(const TIntermLoop& node, const std::string& initialiser) {
  if (uniformity_.parts(node)) return parting_loop(node, nullptr);
  const std::string test = node.getTest() != nullptr ? packets_->self_contained(*node.getTest()) : "";
  const bool own_mask = uniformity_.parts_in_body(node);
  const SourceLine start = source_;
  if (!node.testFirst()) {
    line("do {");
    body(node, "", own_mask, true);
    source_ = start;
    return line("} while (" + test + ");");
  }
  if (context_.program().tree().token_text(node) == "for") {
    const std::string terminal =
        node.getTerminal() != nullptr ? packets_->self_contained_statement(*node.getTerminal()) : "";
    line("for (" + initialiser + ";" + (test.empty() ? "" : " " + test) + ";" +
         (terminal.empty() ? "" : " " + terminal) + ") {");
  } else {
    line("while (" + test + ") {");
  }
  body(node, "", own_mask, true);
  line("}");
}

void PacketFunction::parting_loop(const TIntermLoop& node, const Block* wrapper) {
  const std::vector<std::string> outer = std::exchange(block_names_, {});
  const SourceLine start = source_;
  line("{");
  ++depth_;
  const std::string turning = names_.take("loop");
  line("Bool " + turning + " = " + packets_->mask() + ";");
  masks().push_back(turning);
  if (wrapper != nullptr) declare_loop_variables(*wrapper);
  source_ = start;

  // Statements that say the test, and the pixels that it sends on.
  const auto test = [&] {
    if (node.getTest() == nullptr) return;
    ++depth_;
    const std::string text = packets_->value(*node.getTest());
    prelude();
    line(turning + " = " + turning + " && (" + text + ");");
    --depth_;
  };
  if (!node.testFirst()) {
    line("do {");
    body(node, turning, true, false);
    source_ = start;
    test();
    line("} while (some__(" + turning + "));");
  } else {
    const std::string terminal =
        node.getTerminal() != nullptr ? packets_->self_contained_statement(*node.getTerminal()) : "";
    line("for (;;" + (terminal.empty() ? "" : " " + terminal) + ") {");
    test();
    line("  if (none__(" + turning + ")) break;");
    body(node, turning, true, true);
    line("}");
  }
  masks().pop_back();
  --depth_;
  line("}");
  names_.give_back(turning);
  for (const std::string& name : block_names_) names_.give_back(name);
  block_names_ = outer;
}

// Nothing is left to do where all pixels have jumped.
void PacketFunction::after(const TIntermNode& statement) {
  const TIntermBranch* jump = statement.getAsBranchNode();
  if (jump != nullptr || !uniformity_.may_jump(statement)) return;
  const Frame& frame = frames_.back();
  if (frame.kind == Frame::Kind::function) {
    if (!uniformity_.parts_at_return(function_) && !uniformity_.discards(function_)) return;
    const TIntermTyped& definition = *function_.definition;
    const std::string value = definition.getBasicType() == EbtVoid ? ""
                              : result_.empty()                    ? " {}"
                                                                   : " " + result_;
    line("if (none__(" + mask_ + ")) return" + value + ";");
  } else if (frame.kind == Frame::Kind::loop && frame.can_continue && masks().size() > frame.masks) {
    line("if (none__(" + packets_->mask() + ")) continue;");
  }
}

}  // namespace shadertwin::emit
