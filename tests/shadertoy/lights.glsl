// Quad lights and their weights. x: corner, edge, edge, (point that looks at it), xi and two densities.
// y: (point of the light, area), (normal, pdf), (power heuristic, balance heuristic).
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    QuadLight light = createQuadLight(createQuad(x[0].xyz, x[1].xyz, x[2].xyz), vec3(1.0));
    vec3 target = sampleQuadLight(light, x[4].xy);
    y[0] = vec4(target, light.area);
    y[1] = vec4(light.normal, pdfQuadLight(light, target - x[3].xyz));
    y[2].xy = vec2(powerHeuristic(x[4].z, x[4].w), balanceHeuristic(x[4].z, x[4].w));
}

#include "probe.glsl"
