// A ray through a glass ball of radius 1 around the origin, with a concentric ball in it. Whatever can be refracted is.
// x: ray origin, (direction, 0), (index, inner radius or 0, absorption, 1). y: (direction, length of the way through glass),
// (attenuation, surfaces met), (where the last ray starts, total reflections from within the glass at the outer ball).
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    // Centre and radius come from the inputs: compilers move literals through sums, and a scene has none there.
    vec3 middle = x[1].www;
    Ray ray = createRay(x[0].xyz, x[1].xyz, 0.0);
    float way = 0.0;
    float surfaces = 0.0;
    float trapped = 0.0;
    vec3 throughput = vec3(1.0);
    for (int i = 0; i < 12; i++) {
        HitRecord rec;
        rec.t = FAR;
        bool outer = hit_sphere(createSphere(middle, x[2].w), ray, T_MIN, FAR, rec);
        bool inner = x[2].y != 0.0 && hit_sphere(createSphere(middle, x[2].y), ray, T_MIN, rec.t, rec);
        if (!outer && !inner) {
            break;
        }
        rec.material = createDielectricMaterial(vec3(x[2].z, 0.0, 2.0 * x[2].z), x[2].x, 0.0);
        bool inGlass = dot(ray.d, rec.normal) > 0.0;
        way += inGlass ? distance(rec.pos, ray.from) : 0.0;
        vec3 attenuation = vec3(0.0);
        Ray next = ray;
        float pdf = -1.0;
        if (!scatter(ray, rec, vec4(0.5, 0.5, 0.99999994, 0.5), attenuation, next, pdf)) {
            break;
        }
        trapped += inGlass && !inner && dot(next.d, rec.normal) < 0.0 ? 1.0 : 0.0;
        throughput *= attenuation;
        ray = next;
        surfaces += 1.0;
    }
    y[0] = vec4(ray.d, way);
    y[1] = vec4(throughput, surfaces);
    y[2] = vec4(ray.o, trapped);
}

#include "probe.glsl"
