// A shader as GLSL again, with every value defined that browsers define: where a driver would give whatever a
// register held, or read past the end of an array, it gets what WebGL2 gives.
#pragma once

#include "host/project/project.h"

namespace shadertwin {

// Every pass preprocessed, and then:
// - variables without an initialiser start as zero, those in a loop's body in every turn of it;
// - `out` parameters and the shader's own outputs are zero where their function starts;
// - a function that ends without `return` gives zero;
// - an index that only the running shader knows is clamped to the array, vector or matrix.
// Lines stay where they were, so that messages still name the user's files. A pass that can't be read is left
// as it is, for the player's own compiler to judge.
Project emit_defined(const Project& project);

}  // namespace shadertwin
