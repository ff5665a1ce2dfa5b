#include "host/text/fold.h"

#include <glslang/MachineIndependent/ParseHelper.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "host/text/fold_matrix.h"

using glslang::TIntermAggregate;
using glslang::TIntermConstantUnion;
using glslang::TIntermTyped;
using glslang::TOperator;

namespace shadertwin {
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

constexpr float half_pi = 1.57079632679489661923F;

float arc_sine(float x, float p0, float p1) {
  const float m = std::fabs(x);
  const float p = half_pi + m * ((0.785398163397448309616F - 1.0F) + m * (p0 + m * p1));
  const float sign = x > 0.0F ? 1.0F : x < 0.0F ? -1.0F : 0.0F;
  return sign * (half_pi - std::sqrt(1.0F - m) * p);
}

// As Mesa folds it: the C library's functions of floats, and those that Mesa builds from others.
std::optional<float> fold_function(TOperator op, float x) {
  switch (op) {
    case glslang::EOpSin:
      return std::sin(x);
    case glslang::EOpCos:
      return std::cos(x);
    case glslang::EOpTan:
      return std::sin(x) / std::cos(x);
    case glslang::EOpAsin:
      return arc_sine(x, 0.086566724F, -0.03102955F);
    case glslang::EOpAcos:
      return half_pi - arc_sine(x, 0.08132463F, -0.02363318F);
    case glslang::EOpSinh:
      return 0.5F * (std::exp(x) - std::exp(-x));
    case glslang::EOpCosh:
      return 0.5F * (std::exp(x) + std::exp(-x));
    case glslang::EOpTanh: {
      const float t = std::min(std::max(x, -10.0F), 10.0F);
      return (std::exp(t) - std::exp(-t)) / (std::exp(t) + std::exp(-t));
    }
    case glslang::EOpAsinh: {
      const float length = std::log(std::fabs(x) + std::sqrt(x * x + 1.0F));
      return x > 0.0F ? length : x < 0.0F ? -length : 0.0F;
    }
    case glslang::EOpAcosh:
      return std::log(x + std::sqrt(x * x - 1.0F));
    case glslang::EOpAtanh:
      return 0.5F * std::log((1.0F + x) / (1.0F - x));
    case glslang::EOpExp:
      return std::exp(x);
    case glslang::EOpLog:
      return std::log(x);
    case glslang::EOpExp2:
      return std::exp2(x);
    case glslang::EOpLog2:
      return std::log2(x);
    case glslang::EOpInverseSqrt:
      return 1.0F / std::sqrt(x);
    default:
      return std::nullopt;
  }
}

Values fold_functions(TOperator op, const TIntermTyped& operand) {
  Values result;
  for (const float x : values_of(&operand)) {
    const auto value = fold_function(op, x);
    if (!value) return {};
    result.push_back(*value);
  }
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
    case glslang::EOpReflect: {
      const float twice = 2.0F * dot(b, a);
      Values result;
      for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - twice * b[i]);
      return result;
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

TIntermTyped* made_constant(const glslang::TConstUnionArray& values, const TIntermConstantUnion& operand,
                            const glslang::TType& type) {
  auto* node = new TIntermConstantUnion(values, type);  // in glslang's pool
  node->getWritableType().getQualifier().storage = glslang::EvqConst;
  node->setLoc(operand.getLoc());
  return node;
}

template <class T>
glslang::TConstUnionArray fold_matrix(TOperator op, const TIntermConstantUnion& operand) {
  const int rows = operand.getMatrixRows();
  Columns<T> m(static_cast<std::size_t>(operand.getMatrixCols()));
  for (int i = 0; i < operand.getMatrixCols() * rows; ++i)
    m[static_cast<std::size_t>(i / rows)].push_back(static_cast<T>(operand.getConstArray()[i].getDConst()));
  const std::vector<T> values = matrix_function(op, m);
  glslang::TConstUnionArray folded(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    folded[static_cast<int>(i)].setDConst(static_cast<double>(values[i]));
  return folded;
}

// The functions of one matrix, which glslang leaves for the running shader; null for other functions.
TIntermTyped* fold_matrix(TOperator op, const TIntermConstantUnion& operand, const glslang::TType& type) {
  if (op != glslang::EOpTranspose && op != glslang::EOpDeterminant && op != glslang::EOpMatrixInverse)
    return nullptr;
  return made_constant(
      folding == Folding::float64 ? fold_matrix<double>(op, operand) : fold_matrix<float>(op, operand),
      operand, type);
}

// floatBitsToInt() and its kin, for which the same holds.
TIntermTyped* fold_bits(TOperator op, const TIntermConstantUnion& operand, const glslang::TType& type) {
  const bool from_float = op == glslang::EOpFloatBitsToInt || op == glslang::EOpFloatBitsToUint;
  if (!from_float && op != glslang::EOpIntBitsToFloat && op != glslang::EOpUintBitsToFloat) return nullptr;
  const glslang::TConstUnionArray& values = operand.getConstArray();
  glslang::TConstUnionArray folded(values.size());
  for (int i = 0; i < values.size(); ++i) {
    const auto bits = from_float ? std::bit_cast<unsigned>(static_cast<float>(values[i].getDConst()))
                      : values[i].getType() == glslang::EbtUint
                          ? values[i].getUConst()
                          : static_cast<unsigned>(values[i].getIConst());
    if (op == glslang::EOpFloatBitsToInt) folded[i].setIConst(static_cast<int>(bits));
    if (op == glslang::EOpFloatBitsToUint) folded[i].setUConst(bits);
    if (!from_float) folded[i].setDConst(static_cast<double>(std::bit_cast<float>(bits)));
  }
  return made_constant(folded, operand, type);
}

// What glslang leaves to the running shader: sinh() and some others. Null for `values` of nothing.
TIntermTyped* made_from(const Values& values, const TIntermConstantUnion& operand,
                        const glslang::TType& type) {
  if (values.empty() || folding == Folding::float64) return nullptr;
  glslang::TConstUnionArray folded(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    folded[static_cast<int>(i)].setDConst(static_cast<double>(values[i]));
  return made_constant(folded, operand, type);
}

// Integers divided by zero, as reference/glsl/README.md has them: all bits are set.
void define_division(TOperator op, const TIntermConstantUnion* right, TIntermTyped* node) {
  TIntermConstantUnion* constant = node != nullptr ? node->getAsConstantUnion() : nullptr;
  const bool divides = op == glslang::EOpDiv || op == glslang::EOpMod;
  if (!divides || constant == nullptr || right == nullptr) return;
  const bool is_int = constant->getBasicType() == glslang::EbtInt;
  if (!is_int && constant->getBasicType() != glslang::EbtUint) return;
  glslang::TConstUnionArray values = constant->getConstArray();  // shares the node's values
  const glslang::TConstUnionArray& divisors = right->getConstArray();
  for (int i = 0; i < values.size(); ++i) {
    if (number_of(divisors[divisors.size() == 1 ? 0 : i]) != 0.0) continue;
    if (is_int)
      values[i].setIConst(-1);
    else
      values[i].setUConst(~0U);
  }
}

// What glslang folded, with `values` where we know better.
TIntermTyped* corrected(TIntermTyped* node, const Values& values) {
  if (folding == Folding::float64) return node;
  return values.empty() ? rounded(node) : with_values(node, values);
}

class EffectFinder : public glslang::TIntermTraverser {
 public:
  bool found = false;

  bool visitAggregate(glslang::TVisit, TIntermAggregate* node) override {
    return note(node->getOp() == glslang::EOpFunctionCall);
  }
  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    return note(node->modifiesState());
  }
  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    return note(node->modifiesState());
  }

 private:
  bool note(bool has_effect) {
    found |= has_effect;
    return true;
  }
};

// f().length() is a constant to glslang, which forgets the call; it becomes (f(), 3).
TIntermTyped* with_effects(glslang::TIntermediate& tree, TIntermNode* operand, TIntermTyped* length,
                           const glslang::TSourceLoc& place) {
  TIntermTyped* typed = operand != nullptr ? operand->getAsTyped() : nullptr;
  if (typed == nullptr || length == nullptr) return length;
  EffectFinder finder;
  typed->traverse(&finder);
  return finder.found ? tree.addComma(typed, length, place) : length;
}

}  // namespace

ConstantFolding::ConstantFolding(Folding wanted) : previous_(folding) {
  folding = wanted;
}
ConstantFolding::~ConstantFolding() {
  folding = previous_;
}

}  // namespace shadertwin

// The linker's --wrap sends glslang's calls of NAME here and calls of __real_NAME to glslang. A member
// function takes its object as the first argument. NOLINTBEGIN(bugprone-reserved-identifier)
#define FOLD_BINARY _ZNK7glslang20TIntermConstantUnion4foldENS_9TOperatorEPKNS_12TIntermTypedE
#define FOLD_UNARY _ZNK7glslang20TIntermConstantUnion4foldENS_9TOperatorERKNS_5TTypeE
#define FOLD_CALL _ZN7glslang13TIntermediate4foldEPNS_16TIntermAggregateE
#define CALL _ZN7glslang13TParseContext18handleFunctionCallERKNS_10TSourceLocEPNS_9TFunctionEP11TIntermNode
#define LITERAL _ZNK7glslang13TIntermediate16addConstantUnionEdNS_10TBasicTypeERKNS_10TSourceLocEb
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define REAL(name) JOIN(__real_, name)
#define WRAP(name) JOIN(__wrap_, name)

extern "C" {
TIntermTyped* REAL(FOLD_BINARY)(const TIntermConstantUnion* left, TOperator op, const TIntermTyped* right);
TIntermTyped* WRAP(FOLD_BINARY)(const TIntermConstantUnion* left, TOperator op, const TIntermTyped* right) {
  const auto values = shadertwin::fold_product(op, *left, *right);
  TIntermTyped* node = REAL(FOLD_BINARY)(left, op, right);
  shadertwin::define_division(op, right->getAsConstantUnion(), node);
  return shadertwin::corrected(node, values);
}

TIntermTyped* REAL(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op, const glslang::TType& type);
TIntermTyped* WRAP(FOLD_UNARY)(const TIntermConstantUnion* operand, TOperator op,
                               const glslang::TType& type) {
  if (TIntermTyped* node = shadertwin::fold_matrix(op, *operand, type)) return node;
  if (TIntermTyped* node = shadertwin::fold_bits(op, *operand, type)) return node;
  auto values = shadertwin::fold_vector(op, *operand);
  if (values.empty()) values = shadertwin::fold_functions(op, *operand);
  TIntermTyped* node = REAL(FOLD_UNARY)(operand, op, type);
  if (node == nullptr) return shadertwin::made_from(values, *operand, type);
  return shadertwin::corrected(node, values);
}

TIntermTyped* REAL(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call);
TIntermTyped* WRAP(FOLD_CALL)(glslang::TIntermediate* tree, TIntermAggregate* call) {
  const auto values = shadertwin::fold_call(*call);
  return shadertwin::corrected(REAL(FOLD_CALL)(tree, call), values);
}

TIntermTyped* REAL(CALL)(glslang::TParseContext* parser, const glslang::TSourceLoc& loc,
                         glslang::TFunction* function, TIntermNode* arguments);
TIntermTyped* WRAP(CALL)(glslang::TParseContext* parser, const glslang::TSourceLoc& loc,
                         glslang::TFunction* function, TIntermNode* arguments) {
  const bool is_length = function->getBuiltInOp() == glslang::EOpArrayLength;
  TIntermTyped* result = REAL(CALL)(parser, loc, function, arguments);
  return is_length ? shadertwin::with_effects(parser->intermediate, arguments, result, loc) : result;
}

TIntermConstantUnion* REAL(LITERAL)(const glslang::TIntermediate* tree, double value,
                                    glslang::TBasicType type, const glslang::TSourceLoc& loc, bool literal);
TIntermConstantUnion* WRAP(LITERAL)(const glslang::TIntermediate* tree, double value,
                                    glslang::TBasicType type, const glslang::TSourceLoc& loc, bool literal) {
  TIntermConstantUnion* constant = REAL(LITERAL)(tree, value, type, loc, literal);
  shadertwin::rounded(constant);
  return constant;
}
}
// NOLINTEND(bugprone-reserved-identifier)
