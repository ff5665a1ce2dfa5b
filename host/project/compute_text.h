// A fragment pass as a compute shader: data-centre GPUs run those many times faster.
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

// The number that a compiler of compute_text() gives to the first line of head + body + tail: what map_log
// takes as first_line. The rewriting moves no line.
constexpr int compute_first_line = 1;

// The image unit of `shadertwin_target`, the pass's target: rgba32f, written only.
constexpr int compute_target_binding = 7;

// The text of an OpenGL ES 3.1 compute shader with groups of local_x times local_y invocations, one a pixel.
// gl_FragCoord is that of a full-screen triangle at z = 0 (z is 0.5, w is 1). Pixel =
// gl_GlobalInvocationID.xy + the uniform ivec2 `shadertwin_origin`; those outside of iResolution return at
// once. A colour that the shader does not write is (0, 0, 0, 0).
std::string compute_text(const Project& project, const Pass& pass, int local_x, int local_y);

// Whether the pass means the same as a compute shader. `why`, if given, then says what is in the way:
// screen-space derivatives, discard, built-ins of fragments only, texture() on an input with mipmaps, an
// output that the user declares, or a pass that is not a picture.
bool can_run_as_compute(const Pass& pass, std::string* why = nullptr);

}  // namespace shadertwin
