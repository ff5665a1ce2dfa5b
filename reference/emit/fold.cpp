#include "reference/emit/fold.h"

using glslang::TIntermAggregate;
using glslang::TIntermConstantUnion;
using glslang::TIntermTyped;
using glslang::TOperator;

namespace shadertwin::emit {
namespace {

// glslang calls its folding functions without a way to hand anything through them.
thread_local Folding folding = Folding::float64;

TIntermTyped* rounded(TIntermTyped* node) {
  TIntermConstantUnion* constant = node != nullptr ? node->getAsConstantUnion() : nullptr;
  if (folding == Folding::float64 || constant == nullptr) return node;
  glslang::TConstUnionArray values = constant->getConstArray();  // shares the node's values
  for (int i = 0; i < values.size(); ++i) {
    if (values[i].getType() == glslang::EbtDouble)
      values[i].setDConst(static_cast<double>(static_cast<float>(values[i].getDConst())));
  }
  return node;
}

}  // namespace

ConstantFolding::ConstantFolding(Folding wanted) : previous_(folding) {
  folding = wanted;
}
ConstantFolding::~ConstantFolding() {
  folding = previous_;
}

}  // namespace shadertwin::emit

// The linker's --wrap sends glslang's calls of NAME here and calls of __real_NAME to glslang. A member
// function takes its object as the first argument. NOLINTBEGIN(bugprone-reserved-identifier)
#define FOLD_BINARY _ZNK7glslang20TIntermConstantUnion4foldENS_9TOperatorEPKNS_12TIntermTypedE
#define FOLD_UNARY _ZNK7glslang20TIntermConstantUnion4foldENS_9TOperatorERKNS_5TTypeE
#define FOLD_CALL _ZN7glslang13TIntermediate4foldEPNS_16TIntermAggregateE
#define LITERAL _ZNK7glslang13TIntermediate16addConstantUnionEdNS_10TBasicTypeERKNS_10TSourceLocEb
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define REAL(name) JOIN(__real_, name)
#define WRAP(name) JOIN(__wrap_, name)

extern "C" {
TIntermTyped* REAL(FOLD_BINARY)(const TIntermConstantUnion* left, TOperator op, const TIntermTyped* right);
TIntermTyped* WRAP(FOLD_BINARY)(const TIntermConstantUnion* left, TOperator op, const TIntermTyped* right) {
  return shadertwin::emit::rounded(REAL(FOLD_BINARY)(left, op, right));
}

TIntermTyped* REAL(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op, const glslang::TType& type);
TIntermTyped* WRAP(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op,
                               const glslang::TType& type) {
  return shadertwin::emit::rounded(REAL(FOLD_UNARY)(operand, op, type));
}

TIntermTyped* REAL(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call);
TIntermTyped* WRAP(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call) {
  return shadertwin::emit::rounded(REAL(FOLD_CALL)(tree, call));
}

TIntermConstantUnion* REAL(LITERAL)(const glslang::TIntermediate* tree, double value,
                                    glslang::TBasicType type, const glslang::TSourceLoc& loc, bool literal);
TIntermConstantUnion* WRAP(LITERAL)(const glslang::TIntermediate* tree, double value,
                                    glslang::TBasicType type, const glslang::TSourceLoc& loc, bool literal) {
  TIntermConstantUnion* constant = REAL(LITERAL)(tree, value, type, loc, literal);
  shadertwin::emit::rounded(constant);
  return constant;
}
}
// NOLINTEND(bugprone-reserved-identifier)
