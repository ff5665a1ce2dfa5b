#include "reference/emit/operators.h"

#include <string_view>
#include <utility>

namespace shadertwin::emit {

using namespace glslang;

BinaryOperator binary_operator(TOperator op) {
  switch (op) {
    case EOpAdd:
      return {"+", Binding::sum, EOpNull};
    case EOpSub:
      return {"-", Binding::sum, EOpNull};
    case EOpMul:
    case EOpVectorTimesScalar:
    case EOpVectorTimesMatrix:
    case EOpMatrixTimesVector:
    case EOpMatrixTimesScalar:
    case EOpMatrixTimesMatrix:
      return {"*", Binding::product, EOpNull};
    case EOpDiv:
      return {"/", Binding::product, EOpNull};
    case EOpMod:
      return {"%", Binding::product, EOpNull};
    case EOpRightShift:
      return {">>", Binding::shift, EOpNull};
    case EOpLeftShift:
      return {"<<", Binding::shift, EOpNull};
    case EOpAnd:
      return {"&", Binding::bit_and, EOpNull};
    case EOpInclusiveOr:
      return {"|", Binding::bit_or, EOpNull};
    case EOpExclusiveOr:
      return {"^", Binding::bit_xor, EOpNull};
    case EOpEqual:
      return {"==", Binding::equality, EOpNull};
    case EOpNotEqual:
      return {"!=", Binding::equality, EOpNull};
    case EOpLessThan:
      return {"<", Binding::relation, EOpNull};
    case EOpGreaterThan:
      return {">", Binding::relation, EOpNull};
    case EOpLessThanEqual:
      return {"<=", Binding::relation, EOpNull};
    case EOpGreaterThanEqual:
      return {">=", Binding::relation, EOpNull};
    case EOpLogicalOr:
      return {"||", Binding::logical_or, EOpNull};
    case EOpLogicalXor:
      return {"^^", Binding::logical_xor, EOpNull};
    case EOpLogicalAnd:
      return {"&&", Binding::logical_and, EOpNull};
    default:
      return {};
  }
}

BinaryOperator assignment_operator(TOperator op) {
  const auto computing = [](const char* sign, TOperator plain) {
    return BinaryOperator{sign, Binding::assignment, plain};
  };
  switch (op) {
    case EOpAssign:
      return computing("=", EOpNull);
    case EOpAddAssign:
      return computing("+=", EOpAdd);
    case EOpSubAssign:
      return computing("-=", EOpSub);
    case EOpMulAssign:
      return computing("*=", EOpMul);
    case EOpVectorTimesScalarAssign:
      return computing("*=", EOpVectorTimesScalar);
    case EOpVectorTimesMatrixAssign:
      return computing("*=", EOpVectorTimesMatrix);
    case EOpMatrixTimesScalarAssign:
      return computing("*=", EOpMatrixTimesScalar);
    case EOpMatrixTimesMatrixAssign:
      return computing("*=", EOpMatrixTimesMatrix);
    case EOpDivAssign:
      return computing("/=", EOpDiv);
    case EOpModAssign:
      return computing("%=", EOpMod);
    case EOpAndAssign:
      return computing("&=", EOpAnd);
    case EOpInclusiveOrAssign:
      return computing("|=", EOpInclusiveOr);
    case EOpExclusiveOrAssign:
      return computing("^=", EOpExclusiveOr);
    case EOpLeftShiftAssign:
      return computing("<<=", EOpLeftShift);
    case EOpRightShiftAssign:
      return computing(">>=", EOpRightShift);
    default:
      return {};
  }
}

bool is_constructor(TOperator op) {
  return op > EOpConstructGuardStart && op < EOpConstructGuardEnd;
}

bool is_conversion(TOperator op) {
  switch (op) {
    case EOpConvIntToBool:
    case EOpConvUintToBool:
    case EOpConvFloatToBool:
    case EOpConvBoolToInt:
    case EOpConvBoolToUint:
    case EOpConvBoolToFloat:
    case EOpConvIntToUint:
    case EOpConvUintToInt:
    case EOpConvIntToFloat:
    case EOpConvUintToFloat:
    case EOpConvFloatToInt:
    case EOpConvFloatToUint:
      return true;
    default:
      return false;
  }
}

bool is_increment(TOperator op) {
  return op == EOpPostIncrement || op == EOpPostDecrement || op == EOpPreIncrement || op == EOpPreDecrement;
}

Step step_of(TOperator op) {
  return {op == EOpPreIncrement || op == EOpPostIncrement ? '+' : '-',
          op == EOpPreIncrement || op == EOpPreDecrement};
}

bool reads_texture(TOperator op) {
  return op > EOpTextureGuardBegin && op < EOpTextureGuardEnd;
}

bool has_implicit_lod(TOperator op) {
  return op == EOpTexture || op == EOpTextureProj || op == EOpTextureOffset || op == EOpTextureProjOffset;
}

bool is_derivative(TOperator op) {
  return op == EOpDPdx || op == EOpDPdy || op == EOpFwidth;
}

const char* builtin_name(TOperator op) {
  switch (op) {
#define SHADERTWIN_BUILTIN(op, f, ...) \
  case EOp##op:                        \
    return #f;
#define SHADERTWIN_HELPER(f, ...)
#define SHADERTWIN_MEMBER(op, f) SHADERTWIN_BUILTIN(op, f)
#include "reference/glsl/builtins.def"
    case EOpVectorLogicalNot:
      return "not";
    default:
      return nullptr;
  }
}

namespace {

bool is_integer(const TType& type) {
  return type.getBasicType() == EbtInt || type.getBasicType() == EbtUint;
}

// A divisor that C++ can divide by as it is: neither 0 nor -1.
bool is_safe_divisor(const TIntermTyped& node) {
  const TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr) return false;
  for (int i = 0; i < constant->getConstArray().size(); ++i) {
    const TConstUnion& value = constant->getConstArray()[i];
    if (value.getType() == EbtUint ? value.getUConst() == 0
                                   : value.getIConst() == 0 || value.getIConst() == -1)
      return false;
  }
  return true;
}

bool is_safe_shift(const TIntermTyped& node) {
  const TIntermConstantUnion* constant = node.getAsConstantUnion();
  if (constant == nullptr || !constant->getType().isScalar()) return false;
  const TConstUnion& value = constant->getConstArray()[0];
  return value.getType() == EbtUint ? value.getUConst() < 32
                                    : value.getIConst() >= 0 && value.getIConst() < 32;
}

}  // namespace

const char* operation_name(TOperator op) {
  static constexpr std::pair<std::string_view, const char*> names[] = {
      {"+", "add__"},    {"-", "subtract__"},  {"*", "multiply__"},    {"/", "divide__"},
      {"<", "less__"},   {">", "greater__"},   {"<=", "less_equal__"}, {">=", "greater_equal__"},
      {"==", "equal__"}, {"!=", "not_equal__"}};
  const char* const sign = binary_operator(op).sign;
  if (sign == nullptr) return nullptr;
  for (const auto& [known, name] : names)
    if (known == sign) return name;
  return nullptr;
}

const char* integer_function(TOperator op, const TIntermTyped& left, const TIntermTyped& right) {
  if (!is_integer(left.getType())) return nullptr;
  const bool both_scalar = left.getType().isScalar() && right.getType().isScalar();
  switch (op) {
    case EOpDiv:
      return is_safe_divisor(right) && both_scalar ? nullptr : "divide";
    case EOpMod:
      return is_safe_divisor(right) && both_scalar ? nullptr : "modulo";
    case EOpLeftShift:
      return is_safe_shift(right) && both_scalar ? nullptr : "shift_left";
    case EOpRightShift:
      return is_safe_shift(right) && both_scalar ? nullptr : "shift_right";
    default:
      return nullptr;
  }
}

}  // namespace shadertwin::emit
