// GGX. Functions: 0 D, V, G. x: (h, alpha), (NoV, NoL). y: (D, V correlated, V separable, V of the report), (G1, G1 of
// the report). 1 reflectance of metals. x: (F0 or squared eta, cosine), edge tint or squared k. y: Schlick, Gulbrandsen, complex index.
// 2 sampling. x: (v, alpha), xi. y: visible normal, normal.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    if (iFrame == 0) {
        y[0] = vec4(D_GGX(x[0].xyz, x[0].w), V_SmithGGXCorrelated(x[1].x, x[1].y, x[0].w),
                    V_SmithGGX(x[1].x, x[1].y, x[0].w), V_SmithSchlickGGX(x[1].x, x[1].y, x[0].w));
        y[1].xy = vec2(G1_GGX(x[1].x, x[0].w), G1_SchlickGGX(x[1].x, x[0].w));
    } else if (iFrame == 1) {
        y[0].xyz = F_Schlick(x[0].xyz, x[0].w);
        y[1].xyz = F_Gulbrandsen(x[0].xyz, x[1].xyz, x[0].w);
        y[2].xyz = fresnelConductor(x[0].w, x[0].xyz, x[1].xyz);
    } else {
        y[0].xyz = sampleVisibleNormal(x[0].xyz, x[0].w, x[1].xy);
        y[1].xyz = sampleNormal(x[0].w, x[1].xy);
    }
}

#include "probe.glsl"
