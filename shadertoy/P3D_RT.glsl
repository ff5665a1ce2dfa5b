// Path tracer, Buffer A: hit_world, directlighting, rayColor, accumulation. Paste after a scene file.
//
// Writes the mean of all samples so far, linear RGB, and their number in alpha.

#ifdef SHADER_TOY
#iChannel0 "self"
#iChannel0::MinFilter "Nearest"
#iChannel0::MagFilter "Nearest"
#iChannel0::WrapMode "Clamp"
#include "scenes/select.glsl"
#include "common.glsl"
#include "scenes/select.glsl"
#endif

//-------------------------------------------------------------------------------
// Knobs
//-------------------------------------------------------------------------------

// Paths per pixel and frame. More amortise the frame's fixed cost; a frame takes longer. llvmpipe ends all loops of a
// pixel after 65,534 turns, silently. Scene 0 takes 45 a bounce at most, so SAMPLES_PER_FRAME * MAX_BOUNCES <= 1,400.
#ifndef SAMPLES_PER_FRAME
#define SAMPLES_PER_FRAME 1
#endif

// Longest path, in surfaces. A lower limit is faster and loses light: albedo^MAX_BOUNCES of a closed room's.
#ifndef MAX_BOUNCES
#define MAX_BOUNCES 10
#endif

// Russian roulette: the first bounce that may end a path, and the least chance to survive. Later and higher cost time
// on paths that carry little; earlier and lower cost noise. The report: 0 and 0.0.
#ifndef RR_START
#define RR_START 3
#endif
#ifndef RR_FLOOR
#define RR_FLOOR 0.05
#endif

// Point lights. 0: every light at every hit, one shadow ray each. 1: one light picked at random, weighted by their
// number: cheaper by the other shadow rays, noisier.
#ifndef POINT_LIGHT_PICK
#define POINT_LIGHT_PICK 0
#endif

// Direct light. 0: radiometric, inverse square. 1: the report's, Lambert without pi plus Blinn-Phong, no falloff.
#ifndef LIGHT_MODEL
#define LIGHT_MODEL 0
#endif

// The mean is kept in 0: linear light. 1: gamma space, as in the report's assignment: noise turns into a bias.
#ifndef ACCUMULATION
#define ACCUMULATION 0
#endif

#if SAMPLES_PER_FRAME < 1
#error SAMPLES_PER_FRAME is 1 or more
#endif
#if MAX_BOUNCES < 1
#error MAX_BOUNCES is 1 or more
#endif
#if RR_START < 0
#error RR_START is 0 or more
#endif
#if POINT_LIGHT_PICK < 0 || POINT_LIGHT_PICK > 1
#error POINT_LIGHT_PICK is 0 (all) or 1 (one)
#endif
#if LIGHT_MODEL < 0 || LIGHT_MODEL > 1
#error LIGHT_MODEL is 0 (radiometric) or 1 (the report)
#endif
#if ACCUMULATION < 0 || ACCUMULATION > 1
#error ACCUMULATION is 0 (linear) or 1 (gamma)
#endif

//-------------------------------------------------------------------------------
// World
//-------------------------------------------------------------------------------

// The nearest hit with tmin < t < tmax. rec stays as it was when there is none.
bool hit_world(Ray r, float tmin, float tmax, inout HitRecord rec)
{
    return hit_scene(r, tmin, tmax, rec);
}

HitRecord noHit()
{
    return HitRecord(vec3(0.0), vec3(0.0, 1.0, 0.0), FAR, createDiffuseMaterial(vec3(0.0)));
}

// True when nothing stands on the segment between p and q. Both ends are moved off their surfaces; a point without a
// surface (a point light) passes a zero normal.
bool visible(vec3 p, vec3 pNormal, vec3 q, vec3 qNormal, float time)
{
    vec3 toQ = q - p;
    vec3 from = offsetPoint(p, dot(toQ, pNormal) < 0.0 ? -pNormal : pNormal);
    vec3 to = offsetPoint(q, dot(toQ, qNormal) > 0.0 ? -qNormal : qNormal);
    vec3 segment = to - from;
    float reach = length(segment);
    Ray shadow = createRay(from, segment / reach, time);
    HitRecord blocker = noHit();
    return !hit_world(shadow, T_MIN, reach, blocker);
}

//-------------------------------------------------------------------------------
// Direct light
//-------------------------------------------------------------------------------

// The report's shading: Lambert without pi, and Blinn-Phong with a shininess of 8 / r^4 - 2 (0 from r = 1.41 on).
// l and v point away from the surface.
vec3 blinnPhong(Material m, vec3 n, vec3 l, vec3 v)
{
    vec3 h = directionOr(l + v, n);
    float r2 = m.roughness * m.roughness;
    float shininess = max(8.0 / (r2 * r2 + 0.001) - 2.0, 0.0);
    vec3 specular = m.specColor * portablePow(max(dot(n, h), 0.0), shininess);
    return m.albedo + specular;
}

#ifdef HAS_POINT_LIGHTS
// Radiance that leaves rec.pos against r.d because of one point light, with a hard shadow.
vec3 directlighting(PointLight pl, Ray r, HitRecord rec)
{
    vec3 n = dot(r.d, rec.normal) > 0.0 ? -rec.normal : rec.normal;
    vec3 toLight = pl.pos - rec.pos;
    float distance2 = dot(toLight, toLight);
    vec3 l = toLight * inversesqrt(distance2);
    float NoL = dot(n, l);
    if (!(NoL > 0.0) || !visible(rec.pos, rec.normal, pl.pos, vec3(0.0), r.time)) {
        return vec3(0.0);
    }
#if LIGHT_MODEL == 0
    return evaluateBsdf(rec.material, n, -r.d, l) * pl.color * (pl.intensity / distance2);
#else
    return NoL * (blinnPhong(rec.material, n, l, -r.d) * pl.color);
#endif
}
#endif

// All direct light at a hit.
vec3 directlightingAll(Ray r, HitRecord rec, vec3 xi)
{
    vec3 sum = vec3(0.0);
#ifdef HAS_POINT_LIGHTS
#if POINT_LIGHT_PICK == 0
    for (int i = 0; i < POINT_LIGHTS; i++) {
        sum += directlighting(scene_pointLight(i), r, rec);
    }
#else
    int picked = min(int(xi.z * float(POINT_LIGHTS)), POINT_LIGHTS - 1);
    sum += float(POINT_LIGHTS) * directlighting(scene_pointLight(picked), r, rec);
#endif
#endif
    return sum;
}

//-------------------------------------------------------------------------------
// Light transport
//-------------------------------------------------------------------------------

// Radiance along one path that starts with r.
vec3 rayColor(Ray r, uvec3 stream)
{
    vec3 col = vec3(0.0);
    vec3 throughput = vec3(1.0);
    Ray ray = r;
    for (int bounce = 0; bounce < MAX_BOUNCES; bounce++) {
        HitRecord rec = noHit();
        if (!hit_world(ray, T_MIN, FAR, rec)) {
            col += throughput * scene_background(ray.d);
            break;
        }
        col += throughput * rec.material.emissive;

        uint dimension = DIMENSION_BOUNCE + BOUNCE_DIMENSIONS * uint(bounce);
        vec4 xi = random4(stream, dimension);
        vec4 xiLight = random4(stream, dimension + 1u);
        if (sampleableByLights(rec.material)) {
            col += throughput * directlightingAll(ray, rec, xiLight.xyz);
        }

        vec3 attenuation = vec3(0.0);
        Ray scattered = ray;
        float pdf = 0.0;
        if (!scatter(ray, rec, vec4(xi.xyz, xiLight.w), attenuation, scattered, pdf)) {
            break;
        }
        throughput *= attenuation;
        ray = scattered;

        float energy = max3(throughput);
        if (!(energy > 0.0)) {
            break;
        }
        if (bounce >= RR_START) {
            float survival = clamp(energy, RR_FLOOR, 1.0);
            if (!(xi.w < survival)) {
                break;
            }
            throughput /= survival;
        }
    }
    return col;
}

//-------------------------------------------------------------------------------
// Accumulation
//-------------------------------------------------------------------------------

// A sample that isn't a number is dropped: alpha then stays behind the number of frames.
vec4 accumulate(vec4 mean, vec3 color)
{
#if ACCUMULATION == 0
    vec3 c = color;
#else
    vec3 c = toGamma(color);
#endif
    if (!isPlausible(c)) {
        return mean;
    }
    float count = mean.a + 1.0;
    return vec4(mean.rgb + (c - mean.rgb) / count, count);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    uvec2 pixel = uvec2(fragCoord);
    vec4 mean = iFrame == 0 ? vec4(0.0) : texelFetch(iChannel0, ivec2(pixel), 0);
    Camera cam = createCamera(CAMERA_EYE, CAMERA_AT, vec3(0.0, 1.0, 0.0), CAMERA_FOVY, iResolution.x / iResolution.y,
                              CAMERA_APERTURE, CAMERA_FOCUS, 0.0, 1.0);
    for (int i = 0; i < SAMPLES_PER_FRAME; i++) {
        uvec3 stream = uvec3(pixel, uint(iFrame * SAMPLES_PER_FRAME + i));
        vec4 xi = random4(stream, DIMENSION_LENS);
        vec4 xiTime = random4(stream, DIMENSION_TIME);
        vec2 pixel_sample = (vec2(pixel) + xi.xy) / iResolution.xy;
        Ray ray = getRay(cam, pixel_sample, vec3(xi.zw, xiTime.x));
        mean = accumulate(mean, rayColor(ray, stream));
    }
    fragColor = mean;
}
