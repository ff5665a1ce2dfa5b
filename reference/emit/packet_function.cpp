#include "reference/emit/packet_function.h"

#include "reference/emit/operators.h"

namespace shadertwin::emit {

using namespace glslang;

PacketFunction::PacketFunction(CppContext& context, const Function& function, FunctionScope& scope,
                               CppExpressions& expressions, Masks& masks, const Uniformity& uniformity)
    : CppFunction(context, function, scope, expressions), masks_(masks), uniformity_(uniformity) {
  masks_.open();
}

std::string PacketFunction::result_type() const {
  return context_.type(function_.definition->getType(), uniformity_.varies(function_));
}

void PacketFunction::begin() {
  if (!uniformity_.diverges_at_return(function_) || function_.definition->getBasicType() == EbtVoid) return;
  result_ = names_.take("result");
  out_.statement(result_type() + " " + result_ + "{}");
}

std::string PacketFunction::return_result(const std::string& otherwise) const {
  return "return" + (result_.empty() ? otherwise : " " + result_);
}

void PacketFunction::end() {
  if (result_.empty())
    CppFunction::end();
  else if (!ends_with_jump())
    out_.statement(return_result(""));
}

void PacketFunction::reset_out_parameter(const std::string& name) {
  out_.statement("unwritten(" + masks_.of_function() + ", " + name + ")");
}

// The one place where a statement is uniform or divergent.
void PacketFunction::control(const TIntermNode& node, const Block* wrapper) {
  if (!uniformity_.diverges(node))
    CppFunction::control(node, wrapper);
  else if (const TIntermLoop* loop = node.getAsLoopNode())
    divergent_loop(*loop, wrapper);
  else if (const TIntermSelection* selection = node.getAsSelectionNode())
    divergent_selection(*selection);
  else
    divergent_switch(*node.getAsSwitchNode());
}

void PacketFunction::jump(const TIntermBranch& node) {
  switch (node.getFlowOp()) {
    case EOpKill:
      out_.statement("alive__ = alive__ && !" + masks_.current());
      return masks_.leave_by_return();
    case EOpBreak:
      return masks_.leave_by_break();
    case EOpContinue:
      return masks_.leave_by_continue();
    default:
      return return_value(node);
  }
}

void PacketFunction::return_value(const TIntermBranch& node) {
  if (node.getExpression() != nullptr) {
    const Expression value = expressions_.value(*node.getExpression(), uniformity_.varies(function_));
    if (result_.empty()) return out_.statement("return " + value.text);
    out_.statement("set__(" + masks_.current() + ", " + result_ + ", " + value.text + ")");
  }
  if (masks_.is_narrowed() && uniformity_.diverges_at_return(function_)) return masks_.leave_by_return();
  out_.statement(return_result(""));
}

void PacketFunction::divergent_selection(const TIntermSelection& node) {
  Expression condition = expressions_.value(*node.getCondition());
  if (node.getFalseBlock() != nullptr) {
    const std::string name = take_block_name("condition");
    out_.declare("const Bool", name, condition.text);
    condition = {name};
  }
  if (node.getTrueBlock() != nullptr) masks_.where(condition, [&] { statements(node.getTrueBlock()); });
  if (node.getFalseBlock() != nullptr)
    masks_.where({"!" + condition.text}, [&] { statements(node.getFalseBlock()); });
}

// Each group of statements runs under the mask of the pixels whose value has led to it or that have fallen
// through.
void PacketFunction::divergent_switch(const TIntermSwitch& node) {
  const TIntermTyped& selector = *node.getCondition()->getAsTyped();
  const Expression value = expressions_.value(selector);
  out_.begin();
  const std::string chosen = names_.take("selector");
  const std::string inner = names_.take("active");
  out_.declare("const " + context_.type(selector.getType(), uniformity_.varies(selector)), chosen,
               value.text);
  out_.statement("Bool " + inner + " = false");

  const auto label_of = [](const TIntermNode* part, TOperator op) {
    const TIntermBranch* label = part != nullptr ? part->getAsBranchNode() : nullptr;
    return label != nullptr && label->getFlowOp() == op ? label : nullptr;
  };
  const auto add = [](std::string& labels, const std::string& label) {
    labels += (labels.empty() ? "" : " || ") + label;
  };
  const auto equals = [&](const TIntermBranch& label) {
    return chosen + " == " + expressions_.value(*label.getExpression()).text;
  };
  std::string all_labels;
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    if (const TIntermBranch* label = label_of(part, EOpCase)) add(all_labels, equals(*label));
  }
  std::string labels;
  for (const TIntermNode* part : node.getBody()->getSequence()) {
    if (part == nullptr) continue;
    if (const TIntermBranch* label = label_of(part, EOpCase)) {
      add(labels, equals(*label));
    } else if (label_of(part, EOpDefault) != nullptr) {
      add(labels, all_labels.empty() ? "true" : "!(" + all_labels + ")");
    } else {
      if (!labels.empty())
        out_.statement(inner + " = " + inner + " || (" + masks_.current() + " && (" + labels + "))");
      labels.clear();
      masks_.group(inner, [&] { statements(part); });
    }
  }
  names_.give_back(inner);
  names_.give_back(chosen);
  out_.end();
}

// Where pixels skip what is left of a body one by one, it runs under a mask of its own.
void PacketFunction::loop_body(const TIntermLoop& node) {
  masks_.loop_body("", uniformity_.diverges_in_body(node), true, [&] { statements(node.getBody()); });
}

void PacketFunction::divergent_loop(const TIntermLoop& node, const Block* wrapper) {
  const SourceLine start = out_.source();
  with_own_names([&] {
    masks_.loop([&](const std::string& mask) {
      if (wrapper != nullptr) declare_loop_variables(*wrapper);
      out_.at(start);
      const auto test = [&] {
        if (node.getTest() == nullptr) return;
        const Expression condition = expressions_.value(*node.getTest());
        out_.statement(mask + " = " + mask + " && (" + condition.text + ")");
      };
      const auto body = [&](bool can_continue) {
        begin_round();
        masks_.loop_body(mask, true, can_continue, [&] { statements(node.getBody()); });
      };
      if (!node.testFirst()) {
        out_.begin("do");
        body(false);
        out_.at(start);
        test();
        return out_.end("} while (any__(" + mask + "));");
      }
      const std::string terminal =
          node.getTerminal() != nullptr ? expressions_.self_contained_statement(*node.getTerminal()) : "";
      out_.begin("for (;;" + (terminal.empty() ? "" : " " + terminal) + ")");
      test();
      out_.statement("if (none__(" + mask + ")) break");
      body(true);
      out_.end();
    });
  });
}

// Nothing is left to do where all pixels have jumped.
void PacketFunction::after(const TIntermNode& statement) {
  if (statement.getAsBranchNode() != nullptr || !uniformity_.may_jump(statement)) return;
  if (!masks_.is_in_function()) return masks_.continue_if_empty();
  if (!uniformity_.diverges_at_return(function_) && !uniformity_.discards(function_)) return;
  const bool is_void = function_.definition->getBasicType() == EbtVoid;
  out_.statement("if (none__(" + masks_.of_function() + ")) " + return_result(is_void ? "" : " {}"));
}

}  // namespace shadertwin::emit
