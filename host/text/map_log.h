// A compiler's messages, which number the lines of what it was given, as messages about the user's own files.
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

// Turns a compiler's log about render(source) into lines `file:line: error: text`. Knows the forms of Mesa
// (`0:12(5): error: ...`), NVIDIA (`0(12) : error C0000: ...`), ANGLE and glslang (`ERROR: 0:12: ...`). A
// line about what stands in front of the body is kept as it is; what lies behind the body (a missing brace is
// noticed there) is reported on the user's last line.
std::string map_log(const Project& project, const PassSource& source, const std::string& log);

}  // namespace shadertwin
