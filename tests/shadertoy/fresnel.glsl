// Reflectance of dielectrics, and what is left behind an absorbing length.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    if (iFrame == 0) {  // x: cosine, index on the incident side, index on the other
        y[0] = vec4(fresnelDielectric(x[0].x, x[0].y, x[0].z), schlick(x[0].x, x[0].y, x[0].z),
                    fresnelReflectance(x[0].x, x[0].y, x[0].z), 0.0);
    } else {  // x: absorption, length
        y[0].xyz = transmittance(x[0].xyz, x[0].w);
    }
}

#include "probe.glsl"
