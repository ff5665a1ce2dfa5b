// The last stage: the whole text of a pass as a device's compiler gets it, with all that depends on the
// device.
#pragma once

#include <string>
#include <string_view>

#include "host/project/project.h"

namespace shadertwin {

enum class Target {
  fragment,
  // A fragment pass as a compute shader, one invocation a pixel: data-centre GPUs run those many times
  // faster. gl_FragCoord is that of a full-screen triangle at z = 0 (z is 0.5, w is 1). Pixel =
  // gl_GlobalInvocationID.xy + the uniform ivec2 `shadertwin_origin`; those outside of iResolution return at
  // once. A colour that the shader does not write is (0, 0, 0, 0).
  compute,
  vertex,
};

// Invocations of a compute group along x and y.
constexpr int group_size = 8;
// The image unit of `shadertwin_target`, which a compute pass writes: rgba32f.
constexpr int compute_target_binding = 7;

// GLSL ES 3.00, or 3.20 of a precise source; as compute 3.10 or 3.20. Every line of head, body and tail is
// one line of the text, whatever the target.
std::string render(const PassSource& source, Target target = Target::fragment);

// The lines of a text; what stands behind the last line end counts as one.
int line_count(std::string_view text);

// The number of the line that holds the helpers, from 1.
constexpr int helpers_line = 4;

// The number of the body's first line in the rendered text, from 1.
int first_body_line(const PassSource& source);

// Whether the pass means the same as a compute shader. `why`, if given, then says what is in the way:
// screen-space derivatives, discard, built-ins of fragments only, texture() on an input with mipmaps, an
// output that the user declares, or a pass that is not a picture.
bool can_run_as_compute(const Pass& pass, std::string* why = nullptr);

}  // namespace shadertwin
