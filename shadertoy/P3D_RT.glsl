// Path tracer, Buffer A: hit_world, directlighting, rayColor, accumulation. Paste after a scene file.
//
// Writes the mean of all samples so far, linear RGB, and their number in alpha.

#ifdef SHADER_TOY
#iChannel0 "self"
#iChannel0::MinFilter "Nearest"
#iChannel0::MagFilter "Nearest"
#iChannel0::WrapMode "Clamp"
#iChannel1 "cubemaps/forest_{}.jpg"
#iChannel1::Type "CubeMap"
#iChannel2 "cubemaps/city_{}.jpg"
#iChannel2::Type "CubeMap"
#iChannel3 "camera.glsl"
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

// Russian roulette: the first bounce that may end a path, the throughput below which it does, and the least chance to
// survive. A survivor carries the threshold on. An earlier start and a higher threshold save time on paths that carry
// little, and cost noise: at 1.0, half of the paths end that one gray wall has reflected. The report: 0, 1.0 and 0.0.
#ifndef RR_START
#define RR_START 3
#endif
#ifndef RR_THRESHOLD
#define RR_THRESHOLD 0.25
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

// Quad lights. 0: sampling the light and the surface, weighed by the power heuristic, good for small and large lights
// alike. 1: by the balance heuristic. 2: the light only: noise without bound beside a large light. 3: the surface only:
// no shadow rays; noisy for every light that isn't large.
#ifndef LIGHT_STRATEGY
#define LIGHT_STRATEGY 0
#endif

// What surrounds the scene; the scene's own choice unless set. 0: gradient. 1: forest (iChannel1). 2: city (iChannel2).
// 3: black. 4: white, radiance 1: whatever keeps all light becomes invisible in it.
#ifndef BACKGROUND
#define BACKGROUND SCENE_BACKGROUND
#endif

// The mean is kept in 0: linear light. 1: gamma space, as in the report's assignment: noise turns into a bias, and each
// sample's light beyond white is lost. Image then shows it as it is, without EXPOSURE and TONE_CURVE.
#ifndef ACCUMULATION
#define ACCUMULATION 0
#endif

// The buffer's numbers. 0: as the host has them, 32 bits on a desktop. 1: rounded to the 16 bits that phones and old
// browsers give: the count of samples stops at 2,048, and the mean gets no better from there on.
#ifndef BUFFER_FORMAT
#define BUFFER_FORMAT 0
#endif

// Quads are 0: parallelograms. 1: two triangles each.
#ifndef QUAD_TEST
#define QUAD_TEST 0
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
#if LIGHT_STRATEGY < 0 || LIGHT_STRATEGY > 3
#error LIGHT_STRATEGY is 0 (power), 1 (balance), 2 (light) or 3 (surface)
#endif
#if BACKGROUND < 0 || BACKGROUND > 4
#error BACKGROUND is 0 (gradient), 1 (forest), 2 (city), 3 (black) or 4 (white)
#endif
#if ACCUMULATION < 0 || ACCUMULATION > 1
#error ACCUMULATION is 0 (linear) or 1 (gamma)
#endif
#if BUFFER_FORMAT < 0 || BUFFER_FORMAT > 1
#error BUFFER_FORMAT is 0 (the host's) or 1 (half floats)
#endif
#if QUAD_TEST < 0 || QUAD_TEST > 1
#error QUAD_TEST is 0 (parallelogram) or 1 (two triangles)
#endif

//-------------------------------------------------------------------------------
// World
//-------------------------------------------------------------------------------

// A general build must not know how much there is of anything.
#if GENERAL
#define COUNT(n) ((n) + min(iFrame, 0))
#else
#define COUNT(n) (n)
#endif

HitRecord noHit()
{
    return HitRecord(vec3(0.0), vec3(0.0, 1.0, 0.0), FAR, 0.0, createDiffuseMaterial(vec3(0.0)), -1);
}

#if defined(HAS_POINT_LIGHTS) && POINT_LIGHTS == 0
PointLight scene_pointLight(int i)
{
    return createPointLight(vec3(0.0), vec3(0.0), 0.0);
}
#endif

Quad scene_quad(int i)
{
    return createQuad(QUAD[3 * i], QUAD[3 * i + 1], QUAD[3 * i + 2]);
}

bool hit_sceneQuad(Quad quad, Ray r, float tmin, float tmax, inout HitRecord rec)
{
#if QUAD_TEST == 0
    return hit_quad(quad, r, tmin, tmax, rec);
#else
    vec3 opposite = quad.corner + quad.edge1 + quad.edge2;
    bool hit = hit_triangle(createTriangle(quad.corner, quad.corner + quad.edge1, opposite), r, tmin, tmax, rec);
    float t = hit ? rec.t : tmax;
    bool hit2 = hit_triangle(createTriangle(quad.corner, opposite, quad.corner + quad.edge2), r, tmin, t, rec);
    return hit || hit2;
#endif
}

float sceneQuadRoot(Quad quad, Ray r, float tmin, float tmax)
{
#if QUAD_TEST == 0
    return quadRoot(quad, r, tmin, tmax);
#else
    HitRecord rec = noHit();
    return hit_sceneQuad(quad, r, tmin, tmax, rec) ? rec.t : tmax;
#endif
}

// The nearest hit with tmin < t < tmax. rec stays as it was when there is none. Primitives are numbered: quads (lights
// last), spheres, then those of the scene's own structure. Position and normal are only worked out for the nearest.
bool hit_world(Ray r, float tmin, float tmax, inout HitRecord rec)
{
    int nearest = -1;
    float t = tmax;
    for (int i = 0; i < COUNT(QUADS); i++) {
        float ti = sceneQuadRoot(scene_quad(i), r, tmin, t);
        if (ti < t) {
            t = ti;
            nearest = i;
        }
    }
    for (int i = 0; i < COUNT(SPHERES); i++) {
        vec4 s = OPAQUE(SPHERE[i]);
        float ti = sphereRoot(r.o - s.xyz, r.d, s.w, tmin, t);
        if (ti < t) {
            t = ti;
            nearest = QUADS + i;
        }
    }
#ifdef HAS_SMALL_SPHERES
    int cell = nearestSmallSphere(r, tmin, t);
    nearest = cell < 0 ? nearest : QUADS + SPHERES + cell;
#endif

    if (nearest < 0) {
        return false;
    } else if (nearest < COUNT(QUADS)) {
        hit_sceneQuad(scene_quad(nearest), r, tmin, tmax, rec);
    } else if (nearest < COUNT(QUADS + SPHERES)) {
        vec4 s = SPHERE[nearest - QUADS];
        hit_sphere(createSphere(s.xyz, s.w), r, tmin, tmax, rec);
    }
#ifdef HAS_SMALL_SPHERES
    if (cell >= 0) {
        hit_movingSphere(smallSphere(cell), r, tmin, tmax, rec);
    }
#endif
    rec.material = scene_material(nearest, rec.pos);
    rec.light = nearest < QUADS ? nearest - (QUADS - QUAD_LIGHTS) : -1;
    return true;
}

vec3 background(vec3 d)
{
#if BACKGROUND == 0
    // The report's gradient runs on above the horizon: its parameter reaches 1.6 at the zenith.
    return lerp(vec3(1.0), OPAQUE(vec3(0.5, 0.7, 1.0)), 0.8 * (d.y + 1.0));
#elif BACKGROUND == 1
    return toLinear(textureLod(iChannel1, d, 0.0).rgb);
#elif BACKGROUND == 2
    return toLinear(textureLod(iChannel2, d, 0.0).rgb);
#elif BACKGROUND == 3
    return vec3(0.0);
#else
    return vec3(1.0);
#endif
}

// True when nothing stands on the segment from a hit to q. Both ends are moved off their surfaces; a point without a
// surface (a point light) passes a zero normal.
bool visible(HitRecord rec, vec3 q, vec3 qNormal, float time)
{
    vec3 toQ = q - rec.pos;
    vec3 from = spawnRay(rec, toQ, time).o;
    float error = ROUNDINGS * dot(abs(qNormal), abs(q) + abs(toQ));
    vec3 segment = offsetPoint(q, dot(toQ, qNormal) > 0.0 ? -qNormal : qNormal, error) - from;
    float reach = length(segment);
    Ray shadow = createRay(from, segment / reach, time);
    HitRecord blocker = noHit();
    return !hit_world(shadow, T_MIN, reach, blocker);
}

//-------------------------------------------------------------------------------
// Direct light
//-------------------------------------------------------------------------------

#if LIGHT_STRATEGY == 3 && LIGHT_MODEL == 0
#define SAMPLES_LIGHT 0
#else
#define SAMPLES_LIGHT 1
#endif

// Share of a light sample, and of a surface sample that found a light, in the estimate.
float lightWeight(float pdfLight, float pdfSurface)
{
#if LIGHT_STRATEGY == 0
    return powerHeuristic(pdfLight, pdfSurface);
#elif LIGHT_STRATEGY == 1
    return balanceHeuristic(pdfLight, pdfSurface);
#else
    return 1.0;
#endif
}

float surfaceWeight(float pdfSurface, float pdfLight)
{
#if LIGHT_MODEL == 1 || LIGHT_STRATEGY == 2
    return 0.0;
#elif LIGHT_STRATEGY == 0
    return powerHeuristic(pdfSurface, pdfLight);
#elif LIGHT_STRATEGY == 1
    return balanceHeuristic(pdfSurface, pdfLight);
#else
    return 1.0;
#endif
}

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
    float distance2 = max(dot(toLight, toLight), 1.0e-12);
    vec3 l = directionOr(toLight, n);
    float NoL = dot(n, l);
    if (!(NoL > 0.0) || !visible(rec, pl.pos, vec3(0.0), r.time)) {
        return vec3(0.0);
    }
#if LIGHT_MODEL == 0
    float pdf = 0.0;
    vec3 f = evaluateBsdf(rec.material, n, -r.d, l, pdf);
    return f * ((pl.intensity / distance2) * pl.color);
#else
    return NoL * (blinnPhong(rec.material, n, l, -r.d) * pl.color);
#endif
}
#endif

#ifdef HAS_QUAD_LIGHTS
QuadLight scene_quadLight(int i)
{
    int quad = QUADS - QUAD_LIGHTS + i;
    return createQuadLight(scene_quad(quad), scene_material(quad, vec3(0.0)).emissive);
}

// The same for a point of a quad light, chosen by xi: a soft shadow in the mean.
vec3 directlighting(QuadLight ql, Ray r, HitRecord rec, vec2 xi)
{
    vec3 n = dot(r.d, rec.normal) > 0.0 ? -rec.normal : rec.normal;
    vec3 target = sampleQuadLight(ql, xi);
    vec3 toLight = target - rec.pos;
    float pdf = pdfQuadLight(ql, toLight);
    vec3 l = directionOr(toLight, n);
    float NoL = dot(n, l);
    if (!(NoL > 0.0 && pdf > 0.0) || !visible(rec, target, ql.normal, r.time)) {
        return vec3(0.0);
    }
    vec3 radiance = ql.color / pdf;
#if LIGHT_MODEL == 0
    float pdfSurface = 0.0;
    vec3 f = evaluateBsdf(rec.material, n, -r.d, l, pdfSurface);
    return lightWeight(pdf, pdfSurface) * (f * radiance);
#else
    return (NoL * INV_PI) * (blinnPhong(rec.material, n, l, -r.d) * radiance);
#endif
}
#endif

// Does direct light count here? In the report everything but glass has a highlight.
bool isLit(Material m)
{
#if LIGHT_MODEL == 0
    return isSampleable(m);
#else
    return m.type != DIELECTRIC;
#endif
}

// All direct light at a hit. xi: a point of each quad light, and which point light.
vec3 directlightingAll(Ray r, HitRecord rec, vec3 xi)
{
    vec3 sum = vec3(0.0);
#if defined(HAS_POINT_LIGHTS) && POINT_LIGHT_PICK == 0
    for (int i = 0; i < COUNT(POINT_LIGHTS); i++) {
        sum += directlighting(scene_pointLight(i), r, rec);
    }
#elif defined(HAS_POINT_LIGHTS)
    if (COUNT(POINT_LIGHTS) > 0) {
        int picked = min(int(xi.z * float(POINT_LIGHTS)), POINT_LIGHTS - 1);
        sum += float(POINT_LIGHTS) * directlighting(scene_pointLight(picked), r, rec);
    }
#endif
#if defined(HAS_QUAD_LIGHTS) && SAMPLES_LIGHT
    for (int i = 0; i < COUNT(QUAD_LIGHTS); i++) {
        sum += directlighting(scene_quadLight(i), r, rec, xi.xy);
    }
#endif
    return sum;
}

// What a surface that was hit adds by shining. pdf is the density with which the last surface chose this direction, 0
// where it has none or there was no surface: then no light sample could have found it.
vec3 emission(Ray r, HitRecord rec, float pdf)
{
    if (!(dot(r.d, rec.normal) < 0.0)) {
        return vec3(0.0);
    }
    float weight = 1.0;
#ifdef HAS_QUAD_LIGHTS
    if (rec.light >= 0 && pdf > 0.0) {
        weight = surfaceWeight(pdf, pdfQuadLight(scene_quadLight(rec.light), rec.pos - r.from));
    }
#endif
    return weight * rec.material.emissive;
}

//-------------------------------------------------------------------------------
// Light transport
//-------------------------------------------------------------------------------

// Radiance along one path that starts with r.
vec3 rayColor(Ray r, uvec3 stream)
{
    vec3 col = vec3(0.0);
    vec3 throughput = vec3(1.0);
    float pdf = 0.0;
    Ray ray = r;
    for (int bounce = 0; bounce < MAX_BOUNCES; bounce++) {
        HitRecord rec = noHit();
        if (!hit_world(ray, T_MIN, FAR, rec)) {
            col += throughput * background(ray.d);
            break;
        }
        col += throughput * emission(ray, rec, pdf);

        uint dimension = DIMENSION_BOUNCE + BOUNCE_DIMENSIONS * uint(bounce);
        vec4 xi = random4(stream, dimension);
        vec4 xiLight = random4(stream, dimension + 1u);
        if (isLit(rec.material)) {
            col += throughput * directlightingAll(ray, rec, xiLight.xyz);
        }

        vec3 attenuation = vec3(0.0);
        Ray scattered = ray;
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
            float survival = clamp(energy / RR_THRESHOLD, RR_FLOOR, 1.0);
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
    vec3 c = toGamma(portableExp2(OPAQUE(SCENE_EXPOSURE)) * color);
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
    // Buffer B's state; when it isn't there, or was kept for a picture of another size, the scene's own view.
    vec4 orbit = texelFetch(iChannel3, ivec2(0, 0), 0);
    ivec2 sizeTexel = ivec2(min(2, int(iResolution.x) - 1), 0);
    bool steered = texelFetch(iChannel3, sizeTexel, 0).xy == iResolution.xy;
    bool restart = iFrame == 0 || (steered && orbit.w > 0.0);
    orbit = steered ? orbit : CAMERA_ORBIT;
    vec4 mean = restart ? vec4(0.0) : texelFetch(iChannel0, ivec2(pixel), 0);

    vec3 eye = vec3(0.0);
    vec3 forward = vec3(0.0);
    vec3 up = vec3(0.0);
    vec3 right = vec3(0.0);
    GetCameraVectors(orbit.xyz, CAMERA_AT, eye, forward, up, right);
    Camera cam = createCameraFromVectors(eye, right, up, -forward, orbit.z, OPAQUE(CAMERA_FOVY),
                                         iResolution.x / iResolution.y, OPAQUE(CAMERA_APERTURE),
                                         OPAQUE(CAMERA_FOCUS), 0.0, 1.0);
    for (int i = 0; i < SAMPLES_PER_FRAME; i++) {
        uvec3 stream = uvec3(pixel, uint(iFrame * SAMPLES_PER_FRAME + i));
        vec4 xi = random4(stream, DIMENSION_LENS);
        vec4 xiTime = random4(stream, DIMENSION_TIME);
        vec2 pixel_sample = (vec2(pixel) + xi.xy) / iResolution.xy;
        Ray ray = getRay(cam, pixel_sample, vec3(xi.zw, xiTime.x));
        mean = accumulate(mean, rayColor(ray, stream));
    }
#if BUFFER_FORMAT == 1
    // The largest half is 65,504; beyond it is infinity, which the next frame would never lose.
    mean = min(mean, 65504.0);
    mean = vec4(unpackHalf2x16(packHalf2x16(mean.rg)), unpackHalf2x16(packHalf2x16(mean.ba)));
#endif
    fragColor = mean;
}
