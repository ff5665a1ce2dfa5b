// Everything that a project is worth a warning for before it is played.
#pragma once

#include <string>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

// One line each: project.warnings, and of its texts `file:line: warning: text`: uniforms that nothing sets,
// and a Common that shadertoy.com refuses. `check` finds the latter itself.
std::vector<std::string> all_warnings(const Project& project);

// What that says of a uniform.
std::string words_for_unset(const OtherUniform& uniform);

}  // namespace shadertwin
