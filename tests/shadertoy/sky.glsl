// The cubemap around scene 3. x: a direction. y: background() along it.
#iChannel1 "../../shadertoy/cubemaps/forest_{}.jpg"
#iChannel1::Type "CubeMap"
#include "../../shadertoy/scenes/plastic.glsl"
#include "../../shadertoy/common.glsl"
#include "../../shadertoy/scenes/plastic.glsl"
#undef SHADER_TOY
#define mainImage traceImage
#include "../../shadertoy/P3D_RT.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    y[0] = vec4(background(x[0].xyz), 1.0);
}

#include "probe.glsl"
