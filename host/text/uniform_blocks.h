// Uniform blocks, which no host fills. WebGL2 draws nothing with a program that has one.
#pragma once

#include "host/project/project.h"

namespace shadertwin {

// The stage behind adopt_other_uniforms, for both texts of a pass. A block becomes plain uniforms, or a
// structure and a uniform of it where it has an instance's name, so that the text still means what it did;
// but every entry point of the fragment shader discards as soon as it is called (mainSound returns silence).
// pass.other_uniforms has the first block. Lines stay.
void empty_uniform_blocks(Pass& pass);

}  // namespace shadertwin
