// Rooms whose light is known in closed form. Read twice, like every scene. ROOM: 0 a floor under a light, and a ceiling
// at the height CEILING, if it has one. 1 a closed box whose walls shine and reflect. 2 a hollow ball with point lights
// in its middle, all together of intensity pi. 3 one ball in white light. 4 the left half of the view, shining.

#ifndef COMMON_GLSL

#ifndef ALBEDO
#define ALBEDO 0.5
#endif
#ifndef RADIANCE
#define RADIANCE 1.0
#endif
// Of the light, as seen from the floor.
#ifndef LIGHT_SIZE
#define LIGHT_SIZE vec2(1.0, 1.0)
#endif
#ifndef LIGHT_HEIGHT
#define LIGHT_HEIGHT 1.0
#endif
#ifndef BALL_RADIUS
#define BALL_RADIUS 1.0
#endif
#ifndef BALL_MATERIAL
#define BALL_MATERIAL createDiffuseMaterial(vec3(ALBEDO))
#endif

#define SCENE_NAME 99
#define SCENE_EXPOSURE 0.0
#define SCENE_BACKGROUND 3
#if ROOM == 0
#define HAS_QUAD_LIGHTS
#ifdef CEILING
#define QUADS 3
#else
#define QUADS 2
#endif
#define SPHERES 0
#define POINT_LIGHTS 0
#define QUAD_LIGHTS 1
#elif ROOM == 1
#define QUADS 6
#define SPHERES 0
#define POINT_LIGHTS 0
#define QUAD_LIGHTS 0
#elif ROOM == 2
#define HAS_POINT_LIGHTS
#define QUADS 0
#define SPHERES 1
#ifndef POINT_LIGHTS
#define POINT_LIGHTS 1
#endif
#define QUAD_LIGHTS 0
#elif ROOM == 3
#define HAS_METAL
#define HAS_DIELECTRIC
#define HAS_CONDUCTOR
#define HAS_PLASTIC
#define QUADS 0
#define SPHERES 1
#define POINT_LIGHTS 0
#define QUAD_LIGHTS 0
#else
#define QUADS 1
#define SPHERES 0
#define POINT_LIGHTS 0
#define QUAD_LIGHTS 0
#endif

#define CAMERA_AT vec3(0.0)
#define CAMERA_AZIMUTH 0.0
#define CAMERA_ELEVATION 0.0
#define CAMERA_DISTANCE 10.0
#define CAMERA_MIN_ZOOM 5.0
#define CAMERA_MAX_ZOOM 20.0
#define CAMERA_MIN_ELEVATION -80.0
#define CAMERA_MAX_ELEVATION 80.0
#define CAMERA_FOVY 40.0
#define CAMERA_APERTURE 0.0
#define CAMERA_FOCUS 1.0

#else

#if ROOM == 0
const vec3 QUAD[3 * QUADS] = vec3[3 * QUADS](
    vec3(-1000.0, 0.0, 1000.0), vec3(2000.0, 0.0, 0.0), vec3(0.0, 0.0, -2000.0),
#ifdef CEILING
    vec3(-1000.0, CEILING, 1000.0), vec3(2000.0, 0.0, 0.0), vec3(0.0, 0.0, -2000.0),
#endif
    vec3(-0.5 * LIGHT_SIZE.x, LIGHT_HEIGHT, -0.5 * LIGHT_SIZE.y), vec3(LIGHT_SIZE.x, 0.0, 0.0), vec3(0.0, 0.0, LIGHT_SIZE.y));
#elif ROOM == 1
const vec3 QUAD[18] = vec3[18](
    vec3(-1.0, -1.0, 1.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 0.0, -2.0),
    vec3(-1.0, -1.0, -1.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0),
    vec3(-1.0, 1.0, -1.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 0.0, 2.0),
    vec3(-1.0, -1.0, 1.0), vec3(0.0, 0.0, -2.0), vec3(0.0, 2.0, 0.0),
    vec3(1.0, -1.0, -1.0), vec3(0.0, 0.0, 2.0), vec3(0.0, 2.0, 0.0),
    vec3(1.0, -1.0, 1.0), vec3(-2.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0));
#else
const vec3 QUAD[3] = vec3[3](vec3(-1000.0, -1000.0, 0.0), vec3(1000.0, 0.0, 0.0), vec3(0.0, 2000.0, 0.0));
#endif

const vec4 SPHERE[1] = vec4[1](vec4(0.0, 0.0, 0.0, BALL_RADIUS));

Material scene_material(int primitive, vec3 pos)
{
#if ROOM == 0
    return primitive == QUADS - 1 ? createLightMaterial(vec3(RADIANCE)) : createDiffuseMaterial(vec3(ALBEDO));
#elif ROOM == 3
    return BALL_MATERIAL;
#else
    Material m = createDiffuseMaterial(vec3(ALBEDO));
#if ROOM == 1 || ROOM == 4
    m.emissive = vec3(RADIANCE);
#endif
    return m;
#endif
}

#if ROOM == 2
PointLight scene_pointLight(int i)
{
    // The first is the weakest.
    float share = float(i + 1) / float(POINT_LIGHTS * (POINT_LIGHTS + 1) / 2);
    return createPointLight(vec3(0.0), vec3(1.0), PI * share);
}
#endif

#endif
