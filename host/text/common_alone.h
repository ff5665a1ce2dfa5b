// The Common tab by itself: shadertoy.com compiles it so, besides in front of every pass.
#pragma once

#include <optional>
#include <string>

#include "host/project/project.h"

namespace shadertwin {

// How many lines of the body are the pass's own text: the last ones, behind the knobs and Common.
std::size_t own_lines(const Pass& pass);

// Common as a pass of its own, whose functions see no uniforms but iDate and iSampleRate and no functions of
// other tabs. Nothing where the project has none, or its host does not compile it so.
std::optional<Pass> common_alone(const Project& project);

// The first line that keeps Common from compiling by itself, although the passes compile: `file:line:
// warning: text`. Empty if there is none.
std::string warning_of_common(const Project& project);

}  // namespace shadertwin
