// A pass as readable C++: one function for one function of the shader, under the same names.
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

struct CppOptions {
  bool double_precision = false;  // constants are folded and written as double
  bool loop_guards = false;       // every loop asks whether it has to stop
};

// The whole translation unit for a pass, to be compiled against reference/twin/invocation.h, for
// double_precision with -DSHADERTWIN_DOUBLE. #line directives name the user's own files. Throws Error(shader)
// with lines `file:line: error: text`.
std::string emit_cpp(const Project& project, const Pass& pass, const CppOptions& options = {});

}  // namespace shadertwin
