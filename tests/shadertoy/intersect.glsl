// hit_*. x: (ray origin, tmin), (ray direction, tmax), and the shape. y: (position, t), (normal, 1 for a hit). A record
// that no one wrote to gives -7.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    HitRecord rec;
    rec.pos = vec3(-7.0);
    rec.normal = vec3(-7.0);
    rec.t = -7.0;
    rec.material = createDiffuseMaterial(vec3(0.0));
    rec.light = -7;
    float tmin = x[0].w;
    float tmax = x[1].w;
    Ray ray = createRay(x[0].xyz, x[1].xyz, x[3].w);
    bool hit = false;
    if (iFrame == 0) {  // centre, radius
        hit = hit_sphere(createSphere(x[2].xyz, x[2].w), ray, tmin, tmax, rec);
    } else if (iFrame == 1) {  // (first centre, radius), (last centre, the ray's time), (time0, time1)
        MovingSphere sphere = createMovingSphere(x[2].xyz, x[3].xyz, x[2].w, x[4].x, x[4].y);
        hit = hit_movingSphere(sphere, ray, tmin, tmax, rec);
    } else if (iFrame == 2) {  // corner, edge, edge
        hit = hit_quad(createQuad(x[2].xyz, x[3].xyz, x[4].xyz), ray, tmin, tmax, rec);
    } else {  // corners
        hit = hit_triangle(createTriangle(x[2].xyz, x[3].xyz, x[4].xyz), ray, tmin, tmax, rec);
    }
    y[0] = vec4(rec.pos, rec.t);
    y[1] = vec4(rec.normal, hit ? 1.0 : 0.0);
}

#include "probe.glsl"
