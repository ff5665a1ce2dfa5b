// Values that a compiler finds before the shader runs, by unrolling loops and by compiling functions into
// their callers: it computes sin(), exp() ... of them by a library of its own, with other bits than the
// device gives.
#pragma once

#include "host/project/project.h"

namespace shadertwin {

// Takes what such functions are called with from bits that no compiler knows, and that are the same.
// Constants stay: all compute those beforehand. Throws Error(shader) as emit_cpp does.
PassSource hide_known_values(const Project& project, const PassSource& source);

}  // namespace shadertwin
