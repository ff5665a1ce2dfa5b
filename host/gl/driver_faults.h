// Which mistakes a driver makes, found out by trying.
#pragma once

#include "host/gl/functions.h"
#include "host/text/work_around.h"

namespace shadertwin::gl {

// Draws one pixel that shows the mistake, once for every driver that the process uses. A context must be
// current; of its state only the bound texture and framebuffer, the program and the viewport change.
bool shows_fault(const Functions& gl, Fault fault);

}  // namespace shadertwin::gl
