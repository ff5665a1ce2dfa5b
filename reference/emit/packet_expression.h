// GLSL expressions as C++ over packets: eight pixels at once, under the mask of those that run.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/cpp_expression.h"
#include "reference/emit/uniformity.h"

namespace shadertwin::emit {

class PacketExpressions : public CppExpressions {
 public:
  PacketExpressions(CppContext& context, NameScope& names, const Uniformity& uniformity)
      : CppExpressions(context, names), context_(context), names_(names), uniformity_(uniformity) {}

  // The names of the masks from the function's own to that of the pixels that run here. A statement narrows
  // the mask with an inner one; pixels that jump leave the masks up to where they go.
  std::vector<std::string>& masks() { return masks_; }
  const std::string& mask() const { return masks_.back(); }

 protected:
  std::string type_of(const glslang::TIntermTyped& node) const override;
  bool varies(const glslang::TIntermTyped& node) const override { return uniformity_.varies(node); }
  Text widened(const glslang::TIntermTyped& node, Text text) const override;
  Text packed(const glslang::TIntermTyped& node, Text text) const override;
  Text logical(const glslang::TIntermBinary& node) override;
  Text assignment(const glslang::TIntermBinary& node, bool wants_value) override;
  Text increment(const glslang::TIntermUnary& node, bool wants_value) override;
  Text selection(const glslang::TIntermSelection& node) override;
  Text constructor(const glslang::TIntermAggregate& node) override;
  Text builtin_call(const glslang::TIntermAggregate& node) override;
  Text call(const glslang::TIntermAggregate& node, bool wants_value) override;

 private:
  // An element at an index that varies: read into a variable, changed there, and put back.
  struct Element {
    std::string type;
    std::string container;
    std::string index;
    std::string name;
  };
  // An l-value.
  struct Target {
    Place place;
    std::vector<Element> elements;  // each inside the one before
  };

  // `bind`: find it now, since what follows may change its indices.
  Target target(const glslang::TIntermTyped& left, bool bind = false);
  std::string chain(const glslang::TIntermTyped& node, bool bind, std::vector<Element>& elements);
  void read_elements(const Target& target);
  void read_elements_again(const Target& target);
  // The statements that give the target its value, and put its elements back.
  void write(const Target& target, const std::string& value, bool masked);
  void say(const std::string& statement) { prelude_.push_back(statement); }
  // Runs `body` under the mask `condition`, a branch that is skipped if it is empty.
  template <class Body>
  void where(const std::string& condition, const Body& body);
  // A branch of a selection: `text` as the value of `node`.
  std::string branch_value(const glslang::TIntermTyped& selection, const glslang::TIntermTyped& branch);
  bool has_effects(const glslang::TIntermTyped& node) const;

  CppContext& context_;
  NameScope& names_;
  const Uniformity& uniformity_;
  std::vector<std::string> masks_;
};

}  // namespace shadertwin::emit
