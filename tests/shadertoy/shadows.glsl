// Shadows among the moving spheres of scene 0. x: (point, time). y: (visible from the first light, what every sphere by
// itself says, 1 where the direct light is not 0, radiance in the light).
#include "../../shadertoy/scenes/weekend.glsl"
#include "../../shadertoy/common.glsl"
#include "../../shadertoy/scenes/weekend.glsl"
#undef SHADER_TOY
#define mainImage traceImage
#include "../../shadertoy/P3D_RT.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    vec3 p = x[0].xyz;
    vec3 up = vec3(0.0, 1.0, 0.0);
    PointLight light = scene_pointLight(0);
    HitRecord floor = HitRecord(p, up, 1.0, 1.0e-5, createDiffuseMaterial(vec3(1.0)), -1);
    bool open = visible(floor, light.pos, vec3(0.0), x[0].w);

    vec3 from = spawnRay(floor, up, 0.0).o;
    float reach = distance(light.pos, from);
    Ray ray = createRay(from, (light.pos - from) / reach, x[0].w);
    bool blocked = false;
    for (int i = 0; i < SPHERES; i++) {
        HitRecord rec;
        blocked = hit_sphere(createSphere(SPHERE[i].xyz, SPHERE[i].w), ray, 0.0, reach, rec) || blocked;
    }
    for (int i = 0; i < 100; i++) {
        HitRecord rec;
        blocked = (SMALL_SPHERE[i].z >= 0.0 && hit_movingSphere(smallSphere(i), ray, 0.0, reach, rec)) || blocked;
    }

    Ray view = createRay(p + vec3(0.0, 1.0, 0.0), vec3(0.0, -1.0, 0.0), x[0].w);
    vec3 light1 = directlighting(light, view, floor);
    y[0] = vec4(open ? 1.0 : 0.0, blocked ? 0.0 : 1.0, light1.x > 0.0 ? 1.0 : 0.0, light1.x);
}

#include "probe.glsl"
