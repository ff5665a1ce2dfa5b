// Rays that leave a surface they have hit. x: ray origin, direction, (centre, radius), and the new direction.
// y: (t of the first hit, t of the second, 1 for a first hit, 1 for a second), (where the new ray starts, and -1 or 1
// for the side of the surface it leaves to). Functions: 0 sphere, 1 quad (x[2] corner, x[4] and x[5] edges),
// 2 triangle (corners x[2], x[4], x[5]).
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Ray ray = createRay(x[0].xyz, x[1].xyz, 0.0);
    HitRecord rec = HitRecord(vec3(-7.0), vec3(0.0, 1.0, 0.0), -7.0, 0.0, createDiffuseMaterial(vec3(0.0)), -1);
    HitRecord again = rec;
    bool first = false;
    bool second = false;
    if (iFrame == 0) {
        Sphere sphere = createSphere(x[2].xyz, x[2].w);
        first = hit_sphere(sphere, ray, 0.0, FAR, rec);
        ray = spawnRay(rec, x[3].xyz, 0.0);
        second = hit_sphere(sphere, ray, T_MIN, FAR, again);
    } else if (iFrame == 1) {
        Quad quad = createQuad(x[2].xyz, x[4].xyz, x[5].xyz);
        first = hit_quad(quad, ray, 0.0, FAR, rec);
        ray = spawnRay(rec, x[3].xyz, 0.0);
        second = hit_quad(quad, ray, T_MIN, FAR, again);
    } else {
        Triangle triangle = createTriangle(x[2].xyz, x[4].xyz, x[5].xyz);
        first = hit_triangle(triangle, ray, 0.0, FAR, rec);
        ray = spawnRay(rec, x[3].xyz, 0.0);
        second = hit_triangle(triangle, ray, T_MIN, FAR, again);
    }
    y[0] = vec4(rec.t, again.t, first ? 1.0 : 0.0, second ? 1.0 : 0.0);
    y[1] = vec4(ray.o, dot(x[3].xyz, rec.normal) < 0.0 ? -1.0 : 1.0);
}

#include "probe.glsl"
