// The last stage: the whole text of a pass as a device's compiler gets it, with all that depends on the
// device.
#pragma once

#include <string>
#include <string_view>

#include "host/project/project.h"
#include "host/text/shader_stage.h"

namespace shadertwin {

// Invocations of a compute group along x and y.
constexpr int group_size = 8;
// The image unit of `shadertwin_target`, which a compute pass writes: rgba32f.
constexpr int compute_target_binding = 7;

// GLSL ES 3.00, or 3.20 of a precise source; as compute 3.10 or 3.20. Every line of head, body and tail is
// one line of the text, whatever the stage.
std::string render(const PassSource& source, ShaderStage stage = ShaderStage::fragment);

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
