// Every kind of material and light on a ball so large that it is the ground, SCALE times as large and moved by MOVE. Read
// twice, like every scene. Coordinates are multiples of 1/128, so that MOVE rounds none of them up to 2^17.

#ifndef COMMON_GLSL

#ifndef SCALE
#define SCALE 1.0
#endif
#ifndef MOVE
#define MOVE vec3(0.0)
#endif

#define SCENE_NAME 98
#define SCENE_EXPOSURE 0.0
#define SCENE_BACKGROUND 0
#define HAS_METAL
#define HAS_DIELECTRIC
#define HAS_CONDUCTOR
#define HAS_PLASTIC
#define HAS_POINT_LIGHTS
#define HAS_QUAD_LIGHTS
#define HAS_LENS
#define QUADS 2
#define SPHERES 7
#define POINT_LIGHTS 1
#define QUAD_LIGHTS 1

#define CAMERA_AT (MOVE + SCALE * vec3(0.0, 1.0, 0.0))
#define CAMERA_AZIMUTH 20.0
#define CAMERA_ELEVATION 15.0
#define CAMERA_DISTANCE (SCALE * 9.0)
#define CAMERA_MIN_ZOOM (SCALE * 5.0)
#define CAMERA_MAX_ZOOM (SCALE * 20.0)
#define CAMERA_MIN_ELEVATION -80.0
#define CAMERA_MAX_ELEVATION 80.0
#define CAMERA_FOVY 40.0
#define CAMERA_APERTURE (SCALE * 0.0625)
#define CAMERA_FOCUS 1.0

#else

const vec3 QUAD[6] = vec3[6](
    MOVE + SCALE * vec3(-4.0, 0.0, -2.0), SCALE * vec3(8.0, 0.0, 0.0), SCALE * vec3(0.0, 4.0, 0.0),
    MOVE + SCALE * vec3(-1.0, 4.0, -1.0), SCALE * vec3(2.0, 0.0, 0.0), SCALE * vec3(0.0, 0.0, 2.0));

const vec4 SPHERE[7] = vec4[7](
    vec4(MOVE + SCALE * vec3(0.0, -1000.0, 0.0), SCALE * 1000.0), vec4(MOVE + SCALE * vec3(0.0, 1.0, 0.0), SCALE),
    vec4(MOVE + SCALE * vec3(0.0, 1.0, 0.0), SCALE * -0.75), vec4(MOVE + SCALE * vec3(-2.0, 0.75, 0.0), SCALE * 0.75),
    vec4(MOVE + SCALE * vec3(2.0, 0.75, 0.0), SCALE * 0.75), vec4(MOVE + SCALE * vec3(-1.0, 0.5, 2.0), SCALE * 0.5),
    vec4(MOVE + SCALE * vec3(1.0, 0.5, 2.0), SCALE * 0.5));

Material scene_material(int primitive, vec3 pos)
{
    int ball = primitive - QUADS;
    if (primitive == 1) {
        return createLightMaterial(vec3(6.0));
    } else if (ball == 1 || ball == 2) {
        return createDielectricMaterial(vec3(1.0, 0.25, 0.5) / SCALE, 1.5, 0.0);
    } else if (ball == 3) {
        return createConductorMaterial(vec3(0.95, 0.64, 0.54), vec3(1.0), 0.3);
    } else if (ball == 4) {
        return createPlasticMaterial(vec3(0.15, 0.3, 0.75), 0.25);
    } else if (ball == 5) {
        return createMetalMaterial(vec3(0.9), 0.1);
    } else if (ball == 6) {
        return createDielectricMaterial(vec3(0.0), 1.25, 0.1);
    }
    return createDiffuseMaterial(vec3(0.5));
}

PointLight scene_pointLight(int i)
{
    return createPointLight(MOVE + SCALE * vec3(3.0, 5.0, 4.0), vec3(1.0, 0.9, 0.8), (SCALE * SCALE) * 20.0);
}

#endif
