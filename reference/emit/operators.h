// glslang's operators as GLSL writes them.
#pragma once

#include <glslang/Public/ShaderLang.h>
// The tree itself needs the one above it.
#include <glslang/Include/intermediate.h>

namespace shadertwin::emit {

// How tightly an expression binds, the same in GLSL and in C++.
enum class Binding {
  comma,
  assignment,
  conditional,
  logical_or,
  logical_xor,
  logical_and,
  bit_or,
  bit_xor,
  bit_and,
  equality,
  relation,
  shift,
  sum,
  product,
  prefix,
  postfix,
  primary,
};

struct BinaryOperator {
  const char* sign = nullptr;  // "+"; null if the operator isn't one
  Binding binding = Binding::primary;
  glslang::TOperator plain = glslang::EOpNull;  // of an assignment that computes: EOpAdd for EOpAddAssign
};

// + - * / == && ... without assignments.
BinaryOperator binary_operator(glslang::TOperator op);
// = += -= ...; `plain` is EOpNull for =.
BinaryOperator assignment_operator(glslang::TOperator op);

bool is_constructor(glslang::TOperator op);
bool is_conversion(glslang::TOperator op);
bool is_increment(glslang::TOperator op);
// Of ++ and --.
struct Step {
  char sign = '+';
  bool is_prefix = false;  // its value is that behind the step
};
Step step_of(glslang::TOperator op);
// Every function that takes a sampler.
bool reads_texture(glslang::TOperator op);
// Texture lookups that choose their level of detail from the neighbouring pixels.
bool has_implicit_lod(glslang::TOperator op);
bool is_derivative(glslang::TOperator op);

// GLSL's name of a built-in function, null if `op` isn't one.
const char* builtin_name(glslang::TOperator op);

// The function of twin::Shadows that does what an operator does; null if it never loses digits.
const char* operation_name(glslang::TOperator op);

// The function that stands for an integer operator where C++'s own is undefined; null where it never is.
const char* integer_function(glslang::TOperator op, const glslang::TIntermTyped& left,
                             const glslang::TIntermTyped& right);

}  // namespace shadertwin::emit
