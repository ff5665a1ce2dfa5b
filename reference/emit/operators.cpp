#include "reference/emit/operators.h"

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
    case EOpRadians:
      return "radians";
    case EOpDegrees:
      return "degrees";
    case EOpSin:
      return "sin";
    case EOpCos:
      return "cos";
    case EOpTan:
      return "tan";
    case EOpAsin:
      return "asin";
    case EOpAcos:
      return "acos";
    case EOpAtan:
      return "atan";
    case EOpSinh:
      return "sinh";
    case EOpCosh:
      return "cosh";
    case EOpTanh:
      return "tanh";
    case EOpAsinh:
      return "asinh";
    case EOpAcosh:
      return "acosh";
    case EOpAtanh:
      return "atanh";
    case EOpPow:
      return "pow";
    case EOpExp:
      return "exp";
    case EOpLog:
      return "log";
    case EOpExp2:
      return "exp2";
    case EOpLog2:
      return "log2";
    case EOpSqrt:
      return "sqrt";
    case EOpInverseSqrt:
      return "inversesqrt";
    case EOpAbs:
      return "abs";
    case EOpSign:
      return "sign";
    case EOpFloor:
      return "floor";
    case EOpTrunc:
      return "trunc";
    case EOpRound:
      return "round";
    case EOpRoundEven:
      return "roundEven";
    case EOpCeil:
      return "ceil";
    case EOpFract:
      return "fract";
    case EOpMod:
      return "mod";
    case EOpModf:
      return "modf";
    case EOpMin:
      return "min";
    case EOpMax:
      return "max";
    case EOpClamp:
      return "clamp";
    case EOpMix:
      return "mix";
    case EOpStep:
      return "step";
    case EOpSmoothStep:
      return "smoothstep";
    case EOpIsNan:
      return "isnan";
    case EOpIsInf:
      return "isinf";
    case EOpFloatBitsToInt:
      return "floatBitsToInt";
    case EOpFloatBitsToUint:
      return "floatBitsToUint";
    case EOpIntBitsToFloat:
      return "intBitsToFloat";
    case EOpUintBitsToFloat:
      return "uintBitsToFloat";
    case EOpPackSnorm2x16:
      return "packSnorm2x16";
    case EOpUnpackSnorm2x16:
      return "unpackSnorm2x16";
    case EOpPackUnorm2x16:
      return "packUnorm2x16";
    case EOpUnpackUnorm2x16:
      return "unpackUnorm2x16";
    case EOpPackHalf2x16:
      return "packHalf2x16";
    case EOpUnpackHalf2x16:
      return "unpackHalf2x16";
    case EOpLength:
      return "length";
    case EOpDistance:
      return "distance";
    case EOpDot:
      return "dot";
    case EOpCross:
      return "cross";
    case EOpNormalize:
      return "normalize";
    case EOpFaceForward:
      return "faceforward";
    case EOpReflect:
      return "reflect";
    case EOpRefract:
      return "refract";
    case EOpMul:
      return "matrixCompMult";
    case EOpOuterProduct:
      return "outerProduct";
    case EOpDeterminant:
      return "determinant";
    case EOpMatrixInverse:
      return "inverse";
    case EOpTranspose:
      return "transpose";
    case EOpLessThan:
      return "lessThan";
    case EOpLessThanEqual:
      return "lessThanEqual";
    case EOpGreaterThan:
      return "greaterThan";
    case EOpGreaterThanEqual:
      return "greaterThanEqual";
    case EOpVectorEqual:
      return "equal";
    case EOpVectorNotEqual:
      return "notEqual";
    case EOpAny:
      return "any";
    case EOpAll:
      return "all";
    case EOpVectorLogicalNot:
      return "not";
    case EOpDPdx:
      return "dFdx";
    case EOpDPdy:
      return "dFdy";
    case EOpFwidth:
      return "fwidth";
    case EOpTextureQuerySize:
      return "textureSize";
    case EOpTexture:
      return "texture";
    case EOpTextureProj:
      return "textureProj";
    case EOpTextureLod:
      return "textureLod";
    case EOpTextureOffset:
      return "textureOffset";
    case EOpTextureFetch:
      return "texelFetch";
    case EOpTextureFetchOffset:
      return "texelFetchOffset";
    case EOpTextureProjOffset:
      return "textureProjOffset";
    case EOpTextureLodOffset:
      return "textureLodOffset";
    case EOpTextureProjLod:
      return "textureProjLod";
    case EOpTextureProjLodOffset:
      return "textureProjLodOffset";
    case EOpTextureGrad:
      return "textureGrad";
    case EOpTextureGradOffset:
      return "textureGradOffset";
    case EOpTextureProjGrad:
      return "textureProjGrad";
    case EOpTextureProjGradOffset:
      return "textureProjGradOffset";
    default:
      return nullptr;
  }
}

}  // namespace shadertwin::emit
