// Scene 1: fuzzy refraction. Seven balls of the same amber glass before a striped wall, rougher from left to right.
//
// Read twice: before common.glsl it says what the scene needs, after it what stands where.

#ifndef COMMON_GLSL

#define SCENE_NAME 1
#define HAS_DIELECTRIC
#define HAS_QUAD_LIGHTS

#define QUADS 4
#ifndef SPHERES
#define SPHERES 7
#endif
#define POINT_LIGHTS 0
#define QUAD_LIGHTS 1

// Roughness of the last ball; the others share the way to it. 0: clear glass, as the report before its fuzzy
// refractions.
#ifndef FUZZY
#define FUZZY 0.1
#endif

// Degrees, from +z towards +x and above the horizon; distances to the target.
#define CAMERA_AT vec3(0.0, -6.0, 0.0)
#define CAMERA_AZIMUTH 0.0
#define CAMERA_ELEVATION 9.0
#define CAMERA_DISTANCE 34.0
#define CAMERA_MIN_ZOOM 14.0
#define CAMERA_MAX_ZOOM 60.0
#define CAMERA_MIN_ELEVATION -5.0
#define CAMERA_MAX_ELEVATION 80.0
#define CAMERA_FOVY 40.0
#define CAMERA_APERTURE 0.0
#define CAMERA_FOCUS 1.0

#define SCENE_BACKGROUND 1
#define SCENE_EXPOSURE 0.3

#else

// Corner and two edges: floor, striped wall, ceiling, light.
const vec3 QUAD[12] = vec3[12](
    vec3(-25.0, -12.5, 10.0), vec3(50.0, 0.0, 0.0), vec3(0.0, 0.0, -15.0),
    vec3(-25.0, -10.5, -5.0), vec3(50.0, 0.0, 0.0), vec3(0.0, 9.0, 0.0),
    vec3(-7.5, 12.5, -5.0), vec3(15.0, 0.0, 0.0), vec3(0.0, 0.0, 10.0),
    vec3(-5.0, 12.3, -2.5), vec3(10.0, 0.0, 0.0), vec3(0.0, 0.0, 5.0));

// Centre and radius.
const vec4 SPHERE[7] = vec4[7](
    vec4(-18.0, -8.0, 0.0, 2.8), vec4(-12.0, -8.0, 0.0, 2.8), vec4(-6.0, -8.0, 0.0, 2.8), vec4(0.0, -8.0, 0.0, 2.8),
    vec4(6.0, -8.0, 0.0, 2.8), vec4(12.0, -8.0, 0.0, 2.8), vec4(18.0, -8.0, 0.0, 2.8));

Material scene_material(int primitive, vec3 pos)
{
    if (primitive == 3) {
        return createLightMaterial(vec3(20.0, 18.0, 18.0));
    }
    if (primitive == 1) {
        // Black and white, half a unit wide.
        return createDiffuseMaterial(vec3(floor(2.0 * fract(pos.x))));
    }
    if (primitive < 4) {
        return createDiffuseMaterial(vec3(0.7));
    }
    float i = float(primitive - 4);
    return createDielectricMaterial(vec3(0.0, 0.5, 1.0), 1.1, i * (0.166666667 * FUZZY));
}

#endif
