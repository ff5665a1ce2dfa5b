// A shader with every value defined that browsers define: where a driver would give whatever a register held,
// or read past the end of an array, it gets what WebGL2 gives.
#pragma once

#include <optional>

#include "host/project/project.h"

namespace shadertwin {

// The source preprocessed, and then:
// - variables without an initialiser start as zero, those in a loop's body in every turn of it;
// - `out` parameters and the shader's own outputs are zero where their function starts;
// - a function that ends without `return` gives zero;
// - an index that only the running shader knows is clamped to the array, vector or matrix;
// - operations whose operands GLSL does not provide for give what define_operations.h says.
// Lines stay where they were, so that messages still name the user's files. Nothing if the text can't be
// read, which a device's own compiler is then to judge.
std::optional<PassSource> define_undefined(const Project& project, const PassSource& source);

}  // namespace shadertwin
