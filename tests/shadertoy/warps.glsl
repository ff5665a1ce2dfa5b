// Warps of uniform numbers. x: xi. Functions: 0 disk, 1 unit vector, 2 ball, 3 sinCosTurn.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    if (iFrame == 0) {
        y[0].xy = sampleDisk(x[0].xy);
    } else if (iFrame == 1) {
        y[0].xyz = sampleUnitVector(x[0].xy);
    } else if (iFrame == 2) {
        y[0].xyz = sampleBall(x[0].xyz);
    } else {
        y[0].xy = sinCosTurn(x[0].x);
    }
}

#include "probe.glsl"
