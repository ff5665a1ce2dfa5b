// Scene 4: the Cornell box, with plastic, copper and a glass ball that gathers the light into a caustic.
//
// Read twice: before common.glsl it says what the scene needs, after it what stands where.

#ifndef COMMON_GLSL

// 0: the box. 1: the same balls without a room, in a cubemap. 2: a larger box with two balls of thin, fuzzy glass.
#ifndef CORNELL
#define CORNELL 0
#endif
#if CORNELL < 0 || CORNELL > 2
#error CORNELL is 0 (box), 1 (cubemap) or 2 (caustics)
#endif

#define SCENE_NAME 4
#define HAS_DIELECTRIC
#if CORNELL != 2
#define HAS_CONDUCTOR
#define HAS_PLASTIC
#endif
#if CORNELL != 1
#define HAS_QUAD_LIGHTS
#endif

#if CORNELL == 1
#define QUADS 1
#define QUAD_LIGHTS 0
#define SCENE_BACKGROUND 2
#define SCENE_EXPOSURE 0.3
#else
#define QUADS 6
#define QUAD_LIGHTS 1
#define SCENE_BACKGROUND 3
#define SCENE_EXPOSURE -2.1
#endif
#ifndef SPHERES
#if CORNELL == 2
#define SPHERES 2
#else
#define SPHERES 3
#endif
#endif
#define POINT_LIGHTS 0

#if CORNELL == 2
#define HALF_WIDTH 6.0
#define HEIGHT 8.0
#else
#define HALF_WIDTH 4.0
#define HEIGHT 6.0
#endif

// Degrees, from +z towards +x and above the horizon; distances to the target.
#if CORNELL == 1
#define CAMERA_AT vec3(0.0, 1.3, 0.0)
#define CAMERA_AZIMUTH 12.0
#define CAMERA_ELEVATION 9.0
#define CAMERA_DISTANCE 9.5
#else
#define CAMERA_AT vec3(0.0, 0.5 * HEIGHT, 0.0)
#define CAMERA_AZIMUTH 0.0
#define CAMERA_ELEVATION 0.0
#define CAMERA_DISTANCE (HALF_WIDTH + 1.45 * HEIGHT)
#endif
#define CAMERA_MIN_ZOOM (0.9 * HEIGHT)
#define CAMERA_MAX_ZOOM (HALF_WIDTH + 2.5 * HEIGHT)
#define CAMERA_MIN_ELEVATION -10.0
#define CAMERA_MAX_ELEVATION 40.0
#define CAMERA_FOVY 40.0
#define CAMERA_APERTURE 0.0
#define CAMERA_FOCUS 1.0

#else

// Corner and two edges: floor, back, ceiling, left, right, light.
#if CORNELL == 1
const vec3 QUAD[3] = vec3[3](
    vec3(-HALF_WIDTH, 0.0, HALF_WIDTH), vec3(2.0 * HALF_WIDTH, 0.0, 0.0), vec3(0.0, 0.0, -2.0 * HALF_WIDTH));
#else
const vec3 QUAD[18] = vec3[18](
    vec3(-HALF_WIDTH, 0.0, HALF_WIDTH), vec3(2.0 * HALF_WIDTH, 0.0, 0.0), vec3(0.0, 0.0, -2.0 * HALF_WIDTH),
    vec3(-HALF_WIDTH, 0.0, -HALF_WIDTH), vec3(2.0 * HALF_WIDTH, 0.0, 0.0), vec3(0.0, HEIGHT, 0.0),
    vec3(-HALF_WIDTH, HEIGHT, -HALF_WIDTH), vec3(2.0 * HALF_WIDTH, 0.0, 0.0), vec3(0.0, 0.0, 2.0 * HALF_WIDTH),
    vec3(-HALF_WIDTH, 0.0, HALF_WIDTH), vec3(0.0, 0.0, -2.0 * HALF_WIDTH), vec3(0.0, HEIGHT, 0.0),
    vec3(HALF_WIDTH, 0.0, -HALF_WIDTH), vec3(0.0, 0.0, 2.0 * HALF_WIDTH), vec3(0.0, HEIGHT, 0.0),
    vec3(-2.0, HEIGHT - 0.002, -2.0), vec3(4.0, 0.0, 0.0), vec3(0.0, 0.0, 4.0));
#endif

// Centre and radius.
#if CORNELL == 2
const vec4 SPHERE[2] = vec4[2](vec4(-2.5, 2.0, 0.5, 1.5), vec4(2.5, 2.0, 0.5, 1.5));
#else
const vec4 SPHERE[3] = vec4[3](vec4(-2.0, 1.5, -1.5, 1.5), vec4(0.0, 1.5, 1.5, 1.5), vec4(2.0, 1.5, -1.5, 1.5));
#endif

Material scene_material(int primitive, vec3 pos)
{
    int ball = primitive - QUADS;
#if CORNELL == 2
    if (ball >= 0) {
        return createDielectricMaterial(vec3(0.0), ball == 0 ? 1.1 : 1.15, 0.05);
    }
#else
    if (ball == 0) {
        return createPlasticMaterial(vec3(0.15, 0.3, 0.75), 0.25);
    }
    if (ball == 1) {
        return createDielectricMaterial(vec3(0.0), 1.5, 0.0);
    }
    if (ball == 2) {
        return createConductorMaterial(vec3(0.955, 0.638, 0.538), vec3(1.0), 0.3);
    }
#endif
#if CORNELL != 1
    if (primitive == 5) {
        return createLightMaterial(vec3(20.0, 18.0, 14.0));
    }
    if (primitive == 3) {
        return createDiffuseMaterial(vec3(0.9, 0.1, 0.1));
    }
    if (primitive == 4) {
        return createDiffuseMaterial(vec3(0.1, 0.9, 0.1));
    }
#endif
    return createDiffuseMaterial(vec3(0.85));
}

#endif
