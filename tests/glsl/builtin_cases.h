// Every built-in function of GLSL ES 3.00 that computes on numbers, each as one expression for both
// languages.
#pragma once

#include <vector>

#include "tests/glsl/measure.h"

namespace shadertwin::glsl {

std::vector<BuiltinCase> elementary_cases();
std::vector<BuiltinCase> common_cases();
std::vector<BuiltinCase> vector_cases();
std::vector<BuiltinCase> integer_cases();

}  // namespace shadertwin::glsl
