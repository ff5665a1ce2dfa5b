// Mesa's off-screen software renderer: needs neither EGL nor a device. Mesa has it up to version 25.0;
// neither building nor anything else needs it.
#pragma once

#include <memory>

#include "host/gl/context.h"

namespace shadertwin::gl {

// Throws Error(device).
std::unique_ptr<Context> open_osmesa();

}  // namespace shadertwin::gl
