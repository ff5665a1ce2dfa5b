// A surface in white light: the mean of SAMPLES attenuations of one case. x: (type, roughness, cosine, first sample),
// (color, index). y: mean, mean of the squares, (part of the paths that go on, largest, least).
#include "../../shadertoy/common.glsl"
#include "material.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Material m = probeMaterial(int(x[0].x), x[1].xyz, x[0].y, x[1].w, vec3(1.0));
    float sine = sqrt(max(0.0, 1.0 - x[0].z * x[0].z));
    vec3 n = vec3(0.0, 0.6, 0.8);
    vec3 d = vec3(sine, -0.6 * x[0].z, -0.8 * x[0].z);
    Ray ray = createRay(-5.0 * d, normalize(d), 0.0);
    HitRecord rec = HitRecord(vec3(0.0), n, 5.0, 1.0e-6, m, -1);
    vec3 sum = vec3(0.0);
    vec3 squares = vec3(0.0);
    vec3 rest = vec3(0.0, 0.0, 1.0e30);
    for (int i = 0; i < SAMPLES; i++) {
        vec4 xi = random4(uvec3(index, uint(x[0].w), uint(i)), 7u);
        vec3 attenuation = vec3(0.0);
        Ray next = ray;
        float pdf = 0.0;
        bool goesOn = scatter(ray, rec, xi, attenuation, next, pdf);
        vec3 carried = goesOn ? attenuation : vec3(0.0);
        sum += carried;
        squares += carried * carried;
        rest = vec3(rest.x + (goesOn ? 1.0 : 0.0), max(rest.y, max3(carried)), min(rest.z, max3(carried)));
    }
    float share = 1.0 / float(SAMPLES);
    y[0].xyz = share * sum;
    y[1].xyz = share * squares;
    y[2].xyz = vec3(share * rest.x, rest.y, rest.z);
}

#include "probe.glsl"
