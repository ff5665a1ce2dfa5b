// random4. x: pixel, sample, dimension.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    uvec4 key = uvec4(x[0]);
    y[0] = random4(key.xyz, key.w);
}

#include "probe.glsl"
