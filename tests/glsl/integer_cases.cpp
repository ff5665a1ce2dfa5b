#include "tests/glsl/case_macros.h"

// Integers are the bits of the floats drawn; two of them are what a pixel can hold.
#define SHADERTWIN_INTS(expression)                                                \
  "ivec4 i = floatBitsToInt(a), j = floatBitsToInt(b), k = (" #expression          \
  "); "                                                                            \
  "r = halves(uint(k.x), uint(k.y));",                                             \
      [](const Arguments& arguments) {                                             \
        [[maybe_unused]] const vec4 a = arguments.a, b = arguments.b;              \
        [[maybe_unused]] const ivec4 i = floatBitsToInt(a), j = floatBitsToInt(b); \
        const ivec4 k = (expression);                                              \
        return halves(uint(k.x), uint(k.y));                                       \
      }
#define SHADERTWIN_UINTS(expression)                                                 \
  "uvec4 i = floatBitsToUint(a), j = floatBitsToUint(b), k = (" #expression          \
  "); "                                                                              \
  "r = halves(k.x, k.y);",                                                           \
      [](const Arguments& arguments) {                                               \
        [[maybe_unused]] const vec4 a = arguments.a, b = arguments.b;                \
        [[maybe_unused]] const uvec4 i = floatBitsToUint(a), j = floatBitsToUint(b); \
        const uvec4 k = (expression);                                                \
        return halves(k.x, k.y);                                                     \
      }

namespace shadertwin::glsl {

std::vector<BuiltinCase> integer_cases() {
  const std::vector<Domain> two{anything, anything};
  return {
      {"int + int", two, SHADERTWIN_INTS(i + j)},
      {"int - int", two, SHADERTWIN_INTS(i - j)},
      {"int * int", two, SHADERTWIN_INTS(i * j)},
      {"int / int", two, SHADERTWIN_INTS(DIVIDE(i, j))},
      {"int / small int", two, SHADERTWIN_INTS(DIVIDE(i, SHIFT_RIGHT(j, 29)))},
      {"int % int", {unit, unit}, SHADERTWIN_INTS(MODULO(i, SHIFT_RIGHT(j, 16)))},
      {"-int", two, SHADERTWIN_INTS(-i)},
      {"int << int", two, SHADERTWIN_INTS(SHIFT_LEFT(i, j))},
      {"int >> int", two, SHADERTWIN_INTS(SHIFT_RIGHT(i, j))},
      {"int << uint", two, SHADERTWIN_INTS(SHIFT_LEFT(i, floatBitsToUint(b)))},
      {"abs(int)", two, SHADERTWIN_INTS(abs(i))},
      {"sign(int)", two, SHADERTWIN_INTS(sign(i))},
      {"min(int)", two, SHADERTWIN_INTS(min(i, j))},
      {"max(int)", two, SHADERTWIN_INTS(max(i, j.x))},
      {"clamp(int)", two, SHADERTWIN_INTS(clamp(i, -5, 1000000))},
      {"int(float)", two, SHADERTWIN_INTS(MAKE(ivec4, a) + i)},
      {"uint + uint", two, SHADERTWIN_UINTS(i + j)},
      {"uint * uint", two, SHADERTWIN_UINTS(i * j)},
      {"uint / uint", two, SHADERTWIN_UINTS(DIVIDE(i, j))},
      {"uint / small uint", two, SHADERTWIN_UINTS(DIVIDE(i, SHIFT_RIGHT(j, 29)))},
      {"uint % uint", two, SHADERTWIN_UINTS(MODULO(i, j))},
      {"uint % small uint", two, SHADERTWIN_UINTS(MODULO(i, SHIFT_RIGHT(j, 29)))},
      {"uint << uint", two, SHADERTWIN_UINTS(SHIFT_LEFT(i, j))},
      {"uint >> int", two, SHADERTWIN_UINTS(SHIFT_RIGHT(i, floatBitsToInt(b)))},
      {"uint bitwise", two, SHADERTWIN_UINTS((i & j) ^ (i | ~j))},
      {"min(uint)", two, SHADERTWIN_UINTS(min(i, j))},
      {"max(uint)", two, SHADERTWIN_UINTS(max(i, j.x))},
      {"uint(float)", {positive(-8, 32), anything}, SHADERTWIN_UINTS(MAKE(uvec4, a) + i)},
      {"uint(float) out of range", two, SHADERTWIN_UINTS(MAKE(uvec4, a) + i)},
      {"float(int)", {anything}, SHADERTWIN_BODY(r = MAKE(vec4, floatBitsToInt(a)))},
      {"float(uint)", {anything}, SHADERTWIN_BODY(r = MAKE(vec4, floatBitsToUint(a)))},
      {"bool(float)", {anything}, SHADERTWIN_BODY(r = MAKE(vec4, MAKE(bvec4, a)))},
  };
}

}  // namespace shadertwin::glsl
