// Materials. x: (direction of the ray, type), (normal, roughness), (color, index), xi or a direction, (absorption or
// edge tint), origin of the ray. The surface is at (1, 2, 3).
// Functions: 0 scatter. y: (attenuation, 1 if the path goes on), (direction, pdf), new origin - surface.
// 1 evaluateBsdf towards x[3]. y: (BRDF times cosine, pdf), (albedo of the gloss, its probability, its mean).
#include "../../shadertoy/common.glsl"
#include "material.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Material m = probeMaterial(int(x[0].w), x[2].xyz, x[1].w, x[2].w, x[4].xyz);
    vec3 d = x[0].xyz;
    vec3 pos = vec3(1.0, 2.0, 3.0);
    if (iFrame == 0) {
        Ray ray = createRay(x[5].xyz, d, 0.25);
        HitRecord rec = HitRecord(pos, x[1].xyz, 1.0, 1.0e-6, m, -1);
        vec3 attenuation = vec3(0.0);
        Ray next = ray;
        float pdf = -1.0;
        bool goesOn = scatter(ray, rec, x[3], attenuation, next, pdf);
        y[0] = vec4(attenuation, goesOn ? 1.0 : 0.0);
        y[1] = vec4(next.d, pdf);
        y[2] = vec4(next.o - pos, next.time);
    } else {
        vec3 n = dot(d, x[1].xyz) > 0.0 ? -x[1].xyz : x[1].xyz;
        float pdf = -1.0;
        vec3 f = evaluateBsdf(m, n, -d, x[3].xyz, pdf);
        y[0] = vec4(f, pdf);
        y[1] = vec4(glossAlbedo(dot(n, -d), m.roughness), glossProbability(m, dot(n, -d)), glossMean(m.roughness), 0.0);
    }
}

#include "probe.glsl"
