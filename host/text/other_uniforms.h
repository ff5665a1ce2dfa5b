// Uniforms that a shader was given elsewhere: on GLSL Sandbox, in The Book of Shaders, by glslViewer ...
#pragma once

#include "host/project/project.h"

namespace shadertwin {

// The stage between canonicalise and write_host_text. A pass that has only main() says what it was written
// for by the uniforms that it declares: those of known hosts become variables that main() sets first, from
// the uniforms that every player here has, in their host's units:
//
//   time, resolution, surfaceSize         GLSL Sandbox, twigl, VEDA: seconds, pixels, units of the picture's
//                                         height
//   mouse                                 the same: 0 to 1 from the lower left, the middle until it is used
//   backbuffer                            the same: the last picture in bytes, by a free channel
//   frame                                 twigl
//   u_time, u_delta, u_date, u_resolution, u_mouse, u_frame
//                                         The Book of Shaders (glslCanvas), glslViewer: u_mouse in pixels
//   iGlobalTime, iGlobalDelta, iGlobalFrame
//                                         players of older Shadertoy shaders
//   iResolution, iMouse, iFrame of another type than here, where players set as much as the type holds
//   surfacePosition, v_texcoord, v_uv, vUv, which vertex shaders of such hosts give
//
// A pass of the extension's that has mainImage() gets `time`, `resolution` and `mouse`, as there. What else a
// pass declares and nothing sets is zero, a sampler what is on iChannel0: pass.other_uniforms tells. An input
// of a pass without a vertex shader becomes a variable, of which pass.unset_inputs tells where it has no
// meaning above. Lines stay where they are.
void adopt_other_uniforms(const Project& project, std::size_t pass_index, Pass& pass);

}  // namespace shadertwin
