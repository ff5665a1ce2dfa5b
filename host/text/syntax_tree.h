// A shader as glslang's typed tree, with the tokens that its nodes stand for.
#pragma once

#include <glslang/Public/ShaderLang.h>
// The tree itself needs the two above it.
#include <glslang/Include/intermediate.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/project/project.h"
#include "host/text/declarations.h"
#include "host/text/plain_tokens.h"

namespace shadertwin {

// Whether constant expressions are folded in the float arithmetic that a GPU's compiler uses, or in double.
enum class Folding { float32, float64 };

// Whether a parse that fails tells its first error or all of them; later ones may follow from the first.
enum class Errors { first, all };

// A component of a numeric constant.
inline double number_of(const glslang::TConstUnion& value) {
  switch (value.getType()) {
    case glslang::EbtDouble:  // of every float, too
      return value.getDConst();
    case glslang::EbtUint:
      return value.getUConst();
    default:
      return value.getIConst();
  }
}

// Whether the node is a constant and `holds` of each of its components, as doubles.
template <class Test>
bool is_constant_that(const glslang::TIntermTyped& node, Test holds) {
  const glslang::TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr) return false;
  for (int i = 0; i < constant->getConstArray().size(); ++i)
    if (!holds(number_of(constant->getConstArray()[i]))) return false;
  return true;
}

// Of a number, a vector or a matrix of numbers, as GLSL writes it.
std::string type_name(const glslang::TType& type);

class SyntaxTree {
 public:
  // Parses a pass's whole text, `#version 300 es` or `#version 320 es`. Throws Error(shader) with lines
  // `file:line: error: text`.
  SyntaxTree(const Project& project, const PassSource& source, Folding folding,
             Errors errors = Errors::first);

  // The sequence of everything global: initialisers, functions, and the list of global names.
  const glslang::TIntermAggregate& root() const { return *root_; }
  const std::vector<PlainToken>& tokens() const { return tokens_; }
  const Declarations& declarations() const { return *declarations_; }

  // Whether the text says `precise`, so that a GPU's compiler keeps to the order of its operations.
  bool is_precise() const { return is_precise_; }

  // The token that a node stands for, -1 if it stands for none.
  int token_of(const TIntermNode& node) const;
  // The text of that token, empty if there is none.
  const std::string& token_text(const TIntermNode& node) const;
  // The user's own line of a node; file is -1 for the host's text.
  SourceLine line_of(const TIntermNode& node) const;
  SourceLine line_of_token(int token) const;
  // `file:line` for messages about a node or a token.
  std::string place_of(const TIntermNode& node) const;
  std::string place_of_token(int token) const;

 private:
  const Project& project_;
  const PassSource& source_;
  int first_body_line_ = 0;
  bool is_precise_ = false;
  std::unique_ptr<glslang::TShader> shader_;
  std::vector<PlainToken> tokens_;
  std::unique_ptr<Declarations> declarations_;
  const glslang::TIntermAggregate* root_ = nullptr;
};

// Nothing if the parser refuses what a driver may take.
std::optional<SyntaxTree> parsed(const Project& project, const PassSource& source);

}  // namespace shadertwin
