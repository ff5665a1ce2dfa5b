// The probes of warps.glsl and hemisphere.glsl. Inputs are random numbers, and the normal of the hemisphere.
#pragma once

#include "tests/shadertoy/probe.h"

namespace shadertwin::warps {

inline const Probe disk{.file = "warps.glsl", .function = 0};
inline const Probe unit_vector{.file = "warps.glsl", .function = 1};
inline const Probe ball{.file = "warps.glsl", .function = 2};
inline const Probe hemisphere{.file = "hemisphere.glsl", .inputs = 2, .outputs = 3};

}  // namespace shadertwin::warps
