// A shader as a driver with faults gets it: rewritten where that driver would get it wrong.
#pragma once

#include <functional>

#include "host/project/project.h"

namespace shadertwin {

// Mistakes of drivers. host/gl/driver_faults.cpp has the table: who makes them, and a shader that shows each.
enum class Fault {
  half_arithmetic,  // what is computed from unpackHalf2x16() directly is computed in 16 bits
  lost_continue,    // a loop ends at a `continue`, if its last statement or a switch around it jumps too
};

// Whether the driver makes the mistake. It is asked only if the shader would meet it.
using ShowsFault = std::function<bool(Fault)>;

// `source`: preprocessed. Lines stay where they were.
PassSource work_around(const PassSource& source, const ShowsFault& shows);

}  // namespace shadertwin
