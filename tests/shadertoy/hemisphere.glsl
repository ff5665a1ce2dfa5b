// The cosine-weighted hemisphere and the basis it stands in. x: xi, unit normal. y: direction, first two columns.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    y[0].xyz = sampleCosineHemisphere(x[1].xyz, x[0].xy);
    mat3 basis = basisAround(x[1].xyz);
    y[1].xyz = basis[0];
    y[2].xyz = basis[1];
}

#include "probe.glsl"
