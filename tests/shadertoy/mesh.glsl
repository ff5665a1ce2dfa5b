// How many of the eight triangles of a closed mesh around six corners a ray hits. x: the corners +x -x +y -y +z -z,
// then origin and direction of the ray. y: count, nearest t.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Ray ray = createRay(x[6].xyz, x[7].xyz, 0.0);
    float count = 0.0;
    float nearest = FAR;
    for (int i = 0; i < 8; i++) {
        vec3 a = (i & 1) == 0 ? x[0].xyz : x[1].xyz;
        vec3 b = (i & 2) == 0 ? x[2].xyz : x[3].xyz;
        vec3 c = (i & 4) == 0 ? x[4].xyz : x[5].xyz;
        HitRecord rec;
        if (hit_triangle(createTriangle(a, b, c), ray, 0.0, FAR, rec)) {
            count += 1.0;
            nearest = min(nearest, rec.t);
        }
    }
    y[0].xy = vec2(count, nearest);
}

#include "probe.glsl"
