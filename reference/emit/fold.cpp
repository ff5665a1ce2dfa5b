#include "reference/emit/fold.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

using Values = std::vector<float>;

// The components of a float constant; empty for anything else.
Values values_of(const TIntermTyped* node) {
  const TIntermConstantUnion* constant = node != nullptr ? node->getAsConstantUnion() : nullptr;
  Values values;
  if (constant == nullptr || constant->getBasicType() != glslang::EbtFloat || constant->isArray())
    return values;
  for (int i = 0; i < constant->getConstArray().size(); ++i)
    values.push_back(static_cast<float>(constant->getConstArray()[i].getDConst()));
  return values;
}

TIntermTyped* with_values(TIntermTyped* node, const Values& values) {
  TIntermConstantUnion* constant = node != nullptr ? node->getAsConstantUnion() : nullptr;
  if (constant == nullptr || constant->getConstArray().size() != static_cast<int>(values.size()))
    return rounded(node);
  glslang::TConstUnionArray folded = constant->getConstArray();
  for (std::size_t i = 0; i < values.size(); ++i)
    folded[static_cast<int>(i)].setDConst(static_cast<double>(values[i]));
  return node;
}

float dot(const Values& a, const Values& b) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) sum += a[i] * b[i];
  return sum;
}

// Column-major: `inner` terms a sum.
Values product(const Values& left, const Values& right, int rows, int columns, int inner) {
  Values result;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      float sum = 0.0F;
      for (int i = 0; i < inner; ++i) sum += left[i * rows + row] * right[column * inner + i];
      result.push_back(sum);
    }
  }
  return result;
}

// Sums of products, which rounding the result of a double calculation does not give.
Values fold_product(TOperator op, const TIntermTyped& left, const TIntermTyped& right) {
  const Values a = values_of(&left);
  const Values b = values_of(&right);
  if (a.empty() || b.empty()) return {};
  switch (op) {
    case glslang::EOpMatrixTimesVector:
      return product(a, b, left.getMatrixRows(), 1, left.getMatrixCols());
    case glslang::EOpVectorTimesMatrix:
      return product(a, b, 1, right.getMatrixCols(), right.getMatrixRows());
    case glslang::EOpMatrixTimesMatrix:
      return product(a, b, left.getMatrixRows(), right.getMatrixCols(), left.getMatrixCols());
    default:
      return {};
  }
}

Values fold_vector(TOperator op, const TIntermTyped& operand) {
  const Values v = values_of(&operand);
  if (v.size() < 2) return {};
  if (op == glslang::EOpLength) return {std::sqrt(dot(v, v))};
  if (op != glslang::EOpNormalize) return {};
  const float scale = 1.0F / std::sqrt(dot(v, v));
  Values result;
  for (const float x : v) result.push_back(x * scale);
  return result;
}

Values fold_call(const TIntermAggregate& call) {
  const glslang::TIntermSequence& arguments = call.getSequence();
  if (arguments.size() < 2) return {};
  const Values a = values_of(arguments[0]->getAsTyped());
  const Values b = values_of(arguments[1]->getAsTyped());
  if (a.empty() || b.empty()) return {};
  switch (call.getOp()) {
    case glslang::EOpDot:
      return {dot(a, b)};
    case glslang::EOpCross:
      return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    case glslang::EOpDistance: {
      Values difference;
      for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(a[i] - b[i]);
      return {std::sqrt(dot(difference, difference))};
    }
    case glslang::EOpMix: {
      const Values t = values_of(arguments[2]->getAsTyped());
      Values result;
      for (std::size_t i = 0; i < a.size() && !t.empty(); ++i) {
        const float at = t[t.size() == 1 ? 0 : i];
        result.push_back(a[i] * (1.0F - at) + b[i] * at);
      }
      return result;
    }
    default:
      return {};
  }
}

// What glslang folded, with `values` where we know better.
TIntermTyped* corrected(TIntermTyped* node, const Values& values) {
  if (folding == Folding::float64) return node;
  return values.empty() ? rounded(node) : with_values(node, values);
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
  const auto values = shadertwin::emit::fold_product(op, *left, *right);
  return shadertwin::emit::corrected(REAL(FOLD_BINARY)(left, op, right), values);
}

TIntermTyped* REAL(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op, const glslang::TType& type);
TIntermTyped* WRAP(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op,
                               const glslang::TType& type) {
  const auto values = shadertwin::emit::fold_vector(op, *operand);
  return shadertwin::emit::corrected(REAL(FOLD_UNARY)(operand, op, type), values);
}

TIntermTyped* REAL(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call);
TIntermTyped* WRAP(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call) {
  const auto values = shadertwin::emit::fold_call(*call);
  return shadertwin::emit::corrected(REAL(FOLD_CALL)(tree, call), values);
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
