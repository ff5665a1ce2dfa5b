#include "tests/glsl/case_macros.h"

namespace shadertwin::glsl {

std::vector<BuiltinCase> elementary_cases() {
  return {
      {"sqrt", {anything}, SHADERTWIN_BODY(r = sqrt(a))},
      {"inversesqrt", {anything}, SHADERTWIN_BODY(r = inversesqrt(a))},
      {"exp2", {anything}, SHADERTWIN_BODY(r = exp2(a))},
      {"exp2", {range(7)}, SHADERTWIN_BODY(r = exp2(a))},
      {"exp", {anything}, SHADERTWIN_BODY(r = exp(a))},
      {"exp", {range(7)}, SHADERTWIN_BODY(r = exp(a))},
      {"log2", {anything}, SHADERTWIN_BODY(r = log2(a))},
      {"log2", {positive(-1, 1)}, SHADERTWIN_BODY(r = log2(a))},
      {"log", {anything}, SHADERTWIN_BODY(r = log(a))},
      {"log", {positive(-1, 1)}, SHADERTWIN_BODY(r = log(a))},
      {"pow", {anything, anything}, SHADERTWIN_BODY(r = pow(a, b))},
      {"pow", {positive(-16, 4), scale(-4, 4)}, SHADERTWIN_BODY(r = pow(a, b))},
      {"radians", {anything}, SHADERTWIN_BODY(r = radians(a))},
      {"degrees", {anything}, SHADERTWIN_BODY(r = degrees(a))},
      {"sin", {anything}, SHADERTWIN_BODY(r = sin(a))},
      {"sin", {range(3)}, SHADERTWIN_BODY(r = sin(a))},
      {"sin", {range(20)}, SHADERTWIN_BODY(r = sin(a))},
      {"cos", {anything}, SHADERTWIN_BODY(r = cos(a))},
      {"cos", {range(3)}, SHADERTWIN_BODY(r = cos(a))},
      {"cos", {range(20)}, SHADERTWIN_BODY(r = cos(a))},
      {"tan", {anything}, SHADERTWIN_BODY(r = tan(a))},
      {"tan", {range(3)}, SHADERTWIN_BODY(r = tan(a))},
      {"asin", {anything}, SHADERTWIN_BODY(r = asin(a))},
      {"asin", {range(0)}, SHADERTWIN_BODY(r = asin(a))},
      {"acos", {anything}, SHADERTWIN_BODY(r = acos(a))},
      {"acos", {range(0)}, SHADERTWIN_BODY(r = acos(a))},
      {"atan", {anything}, SHADERTWIN_BODY(r = atan(a))},
      {"atan", {scale(-8, 8)}, SHADERTWIN_BODY(r = atan(a))},
      {"atan(y, x)", {anything, anything}, SHADERTWIN_BODY(r = atan(a, b))},
      {"atan(y, x)", {scale(-8, 8), scale(-8, 8)}, SHADERTWIN_BODY(r = atan(a, b))},
      {"sinh", {anything}, SHADERTWIN_BODY(r = sinh(a))},
      {"sinh", {range(5)}, SHADERTWIN_BODY(r = sinh(a))},
      {"cosh", {anything}, SHADERTWIN_BODY(r = cosh(a))},
      {"cosh", {range(5)}, SHADERTWIN_BODY(r = cosh(a))},
      {"tanh", {anything}, SHADERTWIN_BODY(r = tanh(a))},
      {"tanh", {range(4)}, SHADERTWIN_BODY(r = tanh(a))},
      {"asinh", {anything}, SHADERTWIN_BODY(r = asinh(a))},
      {"asinh", {scale(-8, 16)}, SHADERTWIN_BODY(r = asinh(a))},
      {"acosh", {anything}, SHADERTWIN_BODY(r = acosh(a))},
      {"acosh", {positive(0, 16)}, SHADERTWIN_BODY(r = acosh(a))},
      {"atanh", {anything}, SHADERTWIN_BODY(r = atanh(a))},
      {"atanh", {range(0)}, SHADERTWIN_BODY(r = atanh(a))},
  };
}

}  // namespace shadertwin::glsl
