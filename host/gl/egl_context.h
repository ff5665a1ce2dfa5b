// EGL without a display: the device platform where there is one, else Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <optional>

#include "host/gl/context.h"

namespace shadertwin::gl {

// How many numbers N of "egl:N" there are. Throws Error(device) without an EGL library.
int count_egl();

// Opens device `index`, or the first hardware device that opens, or else the first of all. Throws
// Error(device).
std::unique_ptr<Context> open_egl(std::optional<int> index);

// Opens the device that draws on the processor, whatever GPUs there are. Throws Error(device).
std::unique_ptr<Context> open_software_egl();

}  // namespace shadertwin::gl
