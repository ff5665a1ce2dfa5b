// A shader as GLSL again, with every computation `precise`: the compiler of a GPU then keeps to the
// operations and to the order that the text states, and so to what the CPU twin computes.
#pragma once

#include "host/project/project.h"

namespace shadertwin {

// The source for GLSL ES 3.20, preprocessed, with `precise` on all that is computed: variables, parameters,
// outputs, returned values and conditions. Lines stay where they were, so that messages still name the user's
// files. Throws Error(shader) as emit_cpp does.
PassSource make_precise(const Project& project, const PassSource& source);

}  // namespace shadertwin
