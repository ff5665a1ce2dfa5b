// Means over paths. x: (origin of the ray, first sample), direction. y: mean of SAMPLES paths, mean of their squares,
// (largest, least, values that are no numbers).
#if ROOM == 9
#include "../../shadertoy/scenes/cornell.glsl"
#else
#include "rooms.glsl"
#endif
#include "../../shadertoy/common.glsl"
#if ROOM == 9
#include "../../shadertoy/scenes/cornell.glsl"
#else
#include "rooms.glsl"
#endif
#undef SHADER_TOY
#define mainImage traceImage
#include "../../shadertoy/P3D_RT.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Ray ray = createRay(x[0].xyz, x[1].xyz, 0.0);
    vec3 sum = vec3(0.0);
    vec3 squares = vec3(0.0);
    vec3 rest = vec3(0.0, 1.0e30, 0.0);
    for (int i = 0; i < SAMPLES; i++) {
        vec3 c = rayColor(ray, uvec3(index, uint(x[0].w), uint(i)));
        sum += c;
        squares += c * c;
        rest = vec3(max(rest.x, max3(c)), min(rest.y, min(c.r, min(c.g, c.b))), rest.z + (isPlausible(c) ? 0.0 : 1.0));
    }
    float share = 1.0 / float(SAMPLES);
    y[0].xyz = share * sum;
    y[1].xyz = share * squares;
    y[2].xyz = rest;
}

#include "probe.glsl"
