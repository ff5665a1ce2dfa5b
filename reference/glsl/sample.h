// The filtering behind sampler2D, sampler3D and samplerCube.
#pragma once

#include "reference/glsl/sampler.h"

namespace shadertwin::glsl {

const Sampling& sampling_2d();
const Sampling& sampling_3d();
const Sampling& sampling_cube();

}  // namespace shadertwin::glsl
