// Draws one fragment shader without a window.
#pragma once

#include <memory>

#include "tests/glsl/measure.h"

namespace shadertwin::glsl {

// On Mesa's surfaceless EGL platform. Throws std::runtime_error, with the compiler's log, for what doesn't
// work.
Draw egl_draw();

}  // namespace shadertwin::glsl
