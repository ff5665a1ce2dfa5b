// Random programs in GLSL ES 3.00, to find what the translators get wrong.
#pragma once

#include <cstdint>
#include <string>

namespace shadertwin {

// A Shadertoy pass, always the same one for a seed, that reads itself in channel 0: functions with all kinds
// of parameters, nested structures, arrays, matrices, l-values of every form, jumps out of nested loops and
// switches, and effects inside of expressions, parting from pixel to pixel. Nothing in it is undefined. Its
// floats are multiples of 1/16 below 64, so that every sum and product is exact: the order of evaluation, the
// compiler and the precision may not change a bit.
std::string random_shader(std::uint32_t seed);

}  // namespace shadertwin
