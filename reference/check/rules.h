// What can be said of a shader without running it.
#pragma once

#include <vector>

#include "host/project/project.h"
#include "reference/check/finding.h"

namespace shadertwin::check {

// Errors of an ES 3.00 front end, kind `webgl2`: with any of these the shader can't be run.
std::vector<Finding> compile_errors(const Project& project);

// What browsers refuse although native compilers take it (kind `webgl2`), and names that only one of
// shadertoy.com and the VS Code extension knows (kind `portability`). Text inside #ifdef SHADER_TOY is for
// local hosts, so the site's rules don't hold there.
std::vector<Finding> text_rules(const Project& project);

// Loops without an end, a break, a return or a discard, which browsers refuse, kind `webgl2`. The shader has
// to compile.
std::vector<Finding> endless_loops(const Project& project);

// `out` parameters that some path through their function leaves unwritten, kind `out`. A loop counts as if
// its body ran. The shader has to compile.
std::vector<Finding> unwritten_outputs(const Project& project);

}  // namespace shadertwin::check
