// Globals of GLSL ES 1.00 that start with what is not constant.
#pragma once

#include <string>
#include <string_view>

namespace shadertwin {

// Of a text that was written for GLSL ES 1.00, without directives and macros: `float t = 2.0 * time;` outside
// of functions, which browsers take of that version alone, becomes `float t;` and an assignment where main()
// begins. Lines stay.
std::string assign_globals_in_main(std::string_view body);

}  // namespace shadertwin
