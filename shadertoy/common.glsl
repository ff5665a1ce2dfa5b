// Path tracer, Common tab: random numbers, camera, materials, hit_*, scatter, BRDFs.
//
// Paste after a scene file. Alone it compiles with every feature on. Nothing here reads a uniform or a channel, so
// that each function can be called from a test, on any pass, and on a CPU.
//
// The arithmetic is shaped so that a CPU can repeat it bit for bit: no sin, cos, exp, log or pow built-ins, no product
// of three factors or sum of three terms that ends in a literal (Mesa moves the literal), no a*b + a*c (Mesa factors
// it), no (a + b) - a, no square of a square root (Mesa cancels them), no mix (Mesa picks one of two ways), no sum or product of
// four (Mesa balances them; a division, a max or a difference stops it).

#define COMMON_GLSL

//-------------------------------------------------------------------------------
// Knobs
//-------------------------------------------------------------------------------

// Fresnel reflectance of dielectrics. 0: exact, one sqrt and two divisions more. 1: Schlick (the report's equation 1),
// 0.21 too high at worst for an index of 1.1. 2: Schlick with the incident cosine on both sides (the report's
// assignment): the rim of total reflection is lost.
#ifndef FRESNEL
#define FRESNEL 0
#endif

// Where a spawned ray starts. 0: off the surface by the bound of the hit's rounding error: never hits its own surface,
// at any scale. 1: 0.001 along the normal (the report's assignment), cheaper, fails away from unit scale. 2: the next
// floats (Waechter and Binder), cheap as well; large shapes near the origin, such as a ball for a ground, hit themselves.
#ifndef OFFSET_SCHEME
#define OFFSET_SCHEME 0
#endif

// Quadratic of the ray and sphere. 0: from the closest approach (Haines et al.), accurate far away. 1: textbook
// b*b - c: two dot products fewer, speckles from about 100 radii on.
#ifndef SPHERE_ROOT
#define SPHERE_ROOT 0
#endif

// A sphere's negative radius. 0: makes it a cavity, with its normal towards the centre. 1: the sign is ignored, as in the
// report before its correction: hollow glass refracts like one solid ball inside another.
#ifndef NEGATIVE_RADIUS
#define NEGATIVE_RADIUS 0
#endif

// Random numbers. 0: PCG4D keyed by pixel, sample and dimension. 1: pairs of Owen-scrambled Sobol points, which spread
// evenly over a pixel's samples, for the camera ray and the first SOBOL_BOUNCES surfaces, and PCG4D from there on. 2: a
// float seed that grows by 0.1 a draw and is hashed, as in the report's assignment, but from the sample number, never
// the time.
#ifndef RANDOM_NUMBERS
#define RANDOM_NUMBERS 1
#endif

// Each surface more takes time, and the further along a path, the less a number decides of the pixel's noise.
#ifndef SOBOL_BOUNCES
#define SOBOL_BOUNCES 1
#endif

// Another stream of random numbers for every whole number: the same picture with other noise.
#ifndef SEED
#define SEED 0
#endif

// Microfacets that are hidden. 0: height-correlated Smith. 1: separable Smith, 1 to 3 % darker when rough. 2: the
// report's equations 7 and 8, Schlick's fit with k = alpha / 2: no square roots, 5 to 8 % darker.
#ifndef MASKING
#define MASKING 0
#endif

// How a direction is drawn on a rough metal or plastic. 0: a visible normal. 1: any normal: simpler, a third of the
// samples lost below the surface at grazing angles, weights without bound. 2: the report's, a mirror direction plus
// roughness times a ball: no density, so no light is sampled, and the lobe isn't GGX.
#ifndef SPECULAR_SAMPLING
#define SPECULAR_SAMPLING 0
#endif

// Light that single scattering between microfacets loses on metals (59 % at roughness 1). 0: lost, as in the report.
// 1: given back by scaling the lobe (Turquin): four table reads; not reciprocal.
#ifndef ENERGY_COMPENSATION
#define ENERGY_COMPENSATION 1
#endif

// Under the gloss of plastic. 0: what the gloss lets in and out, by table: all light is kept and none is made. 1: the
// same with Fresnel factors of both directions: no table, up to a tenth darker. 2: all of the albedo, as the report's
// equation 4: up to 1.6 times the light that came in.
#ifndef PLASTIC_DIFFUSE
#define PLASTIC_DIFFUSE 0
#endif

// The report's own scatter weights. 0: physical. 1: diffuse attenuation albedo * cos (equation 3), a third too dark.
#ifndef SEED_ATTENUATION
#define SEED_ATTENUATION 0
#endif

// 0: what the scene doesn't declare is compiled out. 1: all of it is compiled in and no loop's length is known, as in
// one program for all scenes.
#ifndef GENERAL
#define GENERAL 0
#endif

#if FRESNEL < 0 || FRESNEL > 2
#error FRESNEL is 0 (exact), 1 (Schlick) or 2 (Schlick with the incident cosine)
#endif
#if OFFSET_SCHEME < 0 || OFFSET_SCHEME > 2
#error OFFSET_SCHEME is 0 (error bound), 1 (fixed) or 2 (next floats)
#endif
#if SPHERE_ROOT < 0 || SPHERE_ROOT > 1
#error SPHERE_ROOT is 0 (closest approach) or 1 (textbook)
#endif
#if NEGATIVE_RADIUS < 0 || NEGATIVE_RADIUS > 1
#error NEGATIVE_RADIUS is 0 (cavity) or 1 (ignored)
#endif
#if RANDOM_NUMBERS < 0 || RANDOM_NUMBERS > 2
#error RANDOM_NUMBERS is 0 (PCG4D), 1 (Sobol) or 2 (float seed)
#endif
#if SOBOL_BOUNCES < 0
#error SOBOL_BOUNCES is a number of surfaces
#endif
#if MASKING < 0 || MASKING > 2
#error MASKING is 0 (height-correlated Smith), 1 (separable Smith) or 2 (Schlick)
#endif
#if SPECULAR_SAMPLING < 0 || SPECULAR_SAMPLING > 2
#error SPECULAR_SAMPLING is 0 (visible normals), 1 (normals) or 2 (the report)
#endif
#if ENERGY_COMPENSATION < 0 || ENERGY_COMPENSATION > 1
#error ENERGY_COMPENSATION is 0 (none) or 1 (Turquin)
#endif
#if PLASTIC_DIFFUSE < 0 || PLASTIC_DIFFUSE > 2
#error PLASTIC_DIFFUSE is 0 (table), 1 (Fresnel) or 2 (the report)
#endif
#if SEED_ATTENUATION < 0 || SEED_ATTENUATION > 1
#error SEED_ATTENUATION is 0 (physical) or 1 (the report)
#endif
#if GENERAL < 0 || GENERAL > 1
#error GENERAL is 0 (the scene's features) or 1 (all)
#endif

//-------------------------------------------------------------------------------
// Features: what the scene before this file doesn't declare is compiled out
//-------------------------------------------------------------------------------

#if !defined(SCENE_NAME) || GENERAL
#define HAS_LENS
#define HAS_MOTION
#define HAS_METAL
#define HAS_DIELECTRIC
#define HAS_CONDUCTOR
#define HAS_PLASTIC
#define HAS_POINT_LIGHTS
#define HAS_QUAD_LIGHTS
#endif

//-------------------------------------------------------------------------------
// Numbers
//-------------------------------------------------------------------------------

const float PI = 3.14159265358979;
const float INV_PI = 0.318309886183791;
// A literal that compilers can't see: they would move it through sums and products, and a CPU would not. For use where
// iFrame is declared. Adds 0.
#define OPAQUE(x) ((x) + float(min(iFrame, 0)))

const float FAR = 1.0e18;  // squares of lengths below it don't overflow

// 2^y, y clamped to [-126, 127], relative error 1.5e-7. The integer part goes into the exponent field; the rest is
// a minimax polynomial for 2^-f, f in [0, 1).
float portableExp2(float y)
{
    float x = clamp(y, -126.0, 127.0);
    float k = ceil(x);
    float f = k - x;
    float p = 0.000108511245;
    p = p * f - 0.00127305195;
    p = p * f + 0.00957701169;
    p = p * f - 0.0554894209;
    p = p * f + 0.240223974;
    p = p * f - 0.693147004;
    p = p * f + 1.0;
    return p * intBitsToFloat((int(k) + 127) << 23);
}

// log2(x) for normal x > 0, error 1.2e-7 relative near 1. x = m 2^e, m in [sqrt(1/2), sqrt(2)), and a minimax odd
// polynomial in (m - 1) / (m + 1).
float portableLog2(float x)
{
    int bits = floatBitsToInt(x) - 0x3f3504f3;
    int e = bits >> 23;
    float m = intBitsToFloat((bits & 0x007fffff) + 0x3f3504f3);
    float s = (m - 1.0) / (m + 1.0);
    float u = s * s;
    float p = 0.431737751;
    p = p * u + 0.576714337;
    p = p * u + 0.961798847;
    p = p * u + 2.88539004;
    return s * p + float(e);
}

// x^y for x >= 0; 0 for x below the normal floats.
float portablePow(float x, float y)
{
    return x < 1.17549435e-38 ? 0.0 : portableExp2(y * portableLog2(x));
}

// (sin, cos) of 2 pi u for u in [0, 1], error 1.2e-7. Exact reduction to an eighth of a turn, then minimax
// polynomials in r = 4 u - quadrant.
vec2 sinCosTurn(float u)
{
    float x = 4.0 * u;
    float quadrant = floor(x + 0.5);
    float r = x - quadrant;
    float r2 = r * r;
    float s = -0.00460165786;
    s = s * r2 + 0.079680033;
    s = s * r2 - 0.64596349;
    s = s * r2 + 1.57079637;
    s = s * r;
    float c = 0.000903631677;
    c = c * r2 - 0.0208600722;
    c = c * r2 + 0.253669202;
    c = c * r2 - 1.23370051;
    c = c * r2 + 1.0;
    int q = int(quadrant);
    vec2 sc = (q & 1) == 0 ? vec2(s, c) : vec2(c, -s);
    return (q & 2) == 0 ? sc : -sc;
}

// From a to b as t goes from 0 to 1, in the one order that mix leaves open.
float lerp(float a, float b, float t)
{
    return a + t * (b - a);
}

vec3 lerp(vec3 a, vec3 b, float t)
{
    return a + t * (b - a);
}

float max3(vec3 v)
{
    return max(max(v.x, v.y), v.z);
}

// False for NaN, infinities and whatever else a mean can't hold. Sizes are compared as integers: Mesa turns "all are
// less" into "none is greater or equal", which NaN passes.
bool isPlausible(vec3 c)
{
    uvec3 size = floatBitsToUint(c) & 0x7fffffffu;
    return all(lessThan(size, uvec3(0x7149f2cau))) && all(greaterThanEqual(c, vec3(0.0)));
}

// IEC 61966-2-1, both ways, within 3e-7 of the exact curve for c in [0, 1].
float srgbDecode(float c)
{
    return c <= 0.04045 ? c * 0.0773993808 : portablePow((c + 0.055) * 0.947867299, 2.4);
}

float srgbEncode(float c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * portablePow(c, 0.416666667) - 0.055;
}

vec3 toLinear(vec3 c)
{
    return vec3(srgbDecode(c.r), srgbDecode(c.g), srgbDecode(c.b));
}

vec3 toGamma(vec3 c)
{
    vec3 x = clamp(c, 0.0, 1.0);
    return vec3(srgbEncode(x.r), srgbEncode(x.g), srgbEncode(x.b));
}

//-------------------------------------------------------------------------------
// Random numbers
//-------------------------------------------------------------------------------

// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering" (JCGT 9(3)), PCG4D.
uvec4 pcg4d(uvec4 key)
{
    uvec4 v = key * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// A multiply and xor-shift hash of 32 bits (the constants of MurmurHash3's finaliser).
uint hash32(uint key)
{
    uint h = key;
    h ^= h >> 16u;
    h *= 0x85ebca6bu;
    h ^= h >> 13u;
    h *= 0xc2b2ae35u;
    h ^= h >> 16u;
    return h;
}

uint reverseBits(uint v)
{
    uint x = v;
    x = ((x >> 1u) & 0x55555555u) | ((x & 0x55555555u) << 1u);
    x = ((x >> 2u) & 0x33333333u) | ((x & 0x33333333u) << 2u);
    x = ((x >> 4u) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4u);
    x = ((x >> 8u) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8u);
    return (x >> 16u) | (x << 16u);
}

// Owen scrambling of a bit-reversed number by Laine and Karras' hash, in which bits only act on higher ones (constants:
// Burley 2020).
uint laineKarras(uint x, uint seed)
{
    uint h = x + seed;
    h ^= h * 0x6c50b47cu;
    h ^= h * 0xb82f1e52u;
    h ^= h * 0xc7afe638u;
    h ^= h * 0x8d22f6e6u;
    return h;
}

// Burley 2020, "Practical Hash-based Owen Scrambling" (JCGT 9(4)): one of the first two Sobol dimensions each, the
// order of the points shuffled by one seed and their digits scrambled by two more.
uvec2 sobolOwen(uint index, uint shuffle, uint scramble)
{
    uint i = reverseBits(laineKarras(reverseBits(index), shuffle));
    // The second dimension's matrix is Pascal's triangle modulo 2: a product of five butterflies.
    uint pascal = i;
    pascal ^= (pascal >> 1u) & 0x55555555u;
    pascal ^= (pascal >> 2u) & 0x33333333u;
    pascal ^= (pascal >> 4u) & 0x0f0f0f0fu;
    pascal ^= (pascal >> 8u) & 0x00ff00ffu;
    pascal ^= (pascal >> 16u) & 0x0000ffffu;
    return uvec2(reverseBits(laineKarras(i, scramble)), reverseBits(laineKarras(pascal, hash32(scramble))));
}

// Dimensions. A camera ray takes the first two; every bounce takes BOUNCE_DIMENSIONS more.
#define DIMENSION_LENS 0u    // pixel x, y; lens x, y
#define DIMENSION_TIME 1u    // shutter time
#define DIMENSION_BOUNCE 2u  // first bounce
#define BOUNCE_DIMENSIONS 2u // +0: direction x, y; lobe; roulette. +1: light x, y; which light; ball radius

// Four uniform numbers in [0, 1). `stream` is (pixel x, pixel y, sample); `dimension` says what they are for, so that
// no number is ever used twice, whatever path came before. 24 bits: the largest is 1 - 2^-24.
vec4 random4(uvec3 stream, uint dimension)
{
#if RANDOM_NUMBERS == 2
    uint key = stream.x + hash32(stream.y + hash32(stream.z + hash32(uint(SEED))));
    float seed = float(hash32(key) >> 8u) * 5.96046448e-8;
    vec4 seeds = seed + 0.1 * (vec4(1.0, 2.0, 3.0, 4.0) + 4.0 * float(dimension));
    uvec4 bits = floatBitsToUint(seeds);
    return vec4(uvec4(hash32(bits.x), hash32(bits.y), hash32(bits.z), hash32(bits.w)) >> 8u) * 5.96046448e-8;
#else
#if RANDOM_NUMBERS == 1
    if (dimension < DIMENSION_BOUNCE + BOUNCE_DIMENSIONS * uint(SOBOL_BOUNCES)) {
        uvec4 seeds = pcg4d(uvec4(stream.xy, uint(SEED), dimension));
        uvec2 first = sobolOwen(stream.z, seeds.x, seeds.y);
        uvec2 second = sobolOwen(stream.z, seeds.z, seeds.w);
        return vec4(uvec4(first, second) >> 8u) * 5.96046448e-8;
    }
#endif
    return vec4(pcg4d(uvec4(stream, dimension + 2654435769u * uint(SEED))) >> 8u) * 5.96046448e-8;
#endif
}

//-------------------------------------------------------------------------------
// Warps
//-------------------------------------------------------------------------------

// Uniform on the unit disk.
vec2 sampleDisk(vec2 xi)
{
    vec2 sc = sinCosTurn(xi.y);
    return sqrt(xi.x) * vec2(sc.y, sc.x);
}

// Uniform on the unit sphere.
vec3 sampleUnitVector(vec2 xi)
{
    float z = 1.0 - 2.0 * xi.x;
    float r = sqrt(max(0.0, 1.0 - z * z));
    vec2 sc = sinCosTurn(xi.y);
    return vec3(r * sc.y, r * sc.x, z);
}

// Uniform in the unit ball.
vec3 sampleBall(vec3 xi)
{
    return portablePow(xi.z, 0.333333333) * sampleUnitVector(xi.xy);
}

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited" (JCGT 6(1)). The third column is n, of unit length.
mat3 basisAround(vec3 n)
{
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * (n.y * a);
    float sx = side * n.x;
    vec3 t = vec3(1.0 + sx * (n.x * a), side * b, -sx);
    vec3 s = vec3(b, side + n.y * (n.y * a), -n.y);
    return mat3(t, s, n);
}

// From the basis to the world, one column after the other.
vec3 toWorld(mat3 basis, vec3 v)
{
    return v.x * basis[0] + (v.y * basis[1] + v.z * basis[2]);
}

// Density cos / pi around n: a uniform disk, lifted (Malley).
vec3 sampleCosineHemisphere(vec3 n, vec2 xi)
{
    vec2 p = sampleDisk(xi);
    float z = sqrt(max(0.0, 1.0 - dot(p, p)));
    return normalize(toWorld(basisAround(n), vec3(p, z)));
}

//-------------------------------------------------------------------------------
// Rays and camera
//-------------------------------------------------------------------------------

// d has unit length, so that t is a length. `from` is the point the ray leaves: o may stand a few floats beside it.
struct Ray {
    vec3 o;
    vec3 d;
    vec3 from;
    float time;  // within the shutter's [time0, time1]
};

Ray createRay(vec3 o, vec3 d, float time)
{
    return Ray(o, d, o, time);
}

vec3 pointOnRay(Ray r, float t)
{
    return r.o + t * r.d;
}

// p moved off its surface towards the side that n points to. error bounds how far p may stand from the surface.
vec3 offsetPoint(vec3 p, vec3 n, float error)
{
#if OFFSET_SCHEME == 0
    return p + error * n;
#elif OFFSET_SCHEME == 1
    return p + 0.001 * n;
#else
    // Waechter and Binder 2019 (Ray Tracing Gems, chapter 6): by a count of floats away from the origin, by 1/65536 of
    // n near it.
    ivec3 steps = ivec3(256.0 * n);
    ivec3 bits = floatBitsToInt(p);
    vec3 far = intBitsToFloat(ivec3(p.x < 0.0 ? bits.x - steps.x : bits.x + steps.x,
                                    p.y < 0.0 ? bits.y - steps.y : bits.y + steps.y,
                                    p.z < 0.0 ? bits.z - steps.z : bits.z + steps.z));
    vec3 near = p + 1.52587891e-5 * n;
    return vec3(abs(p.x) < 0.03125 ? near.x : far.x, abs(p.y) < 0.03125 ? near.y : far.y,
                abs(p.z) < 0.03125 ? near.z : far.z);
#endif
}

// The nearest t that counts as a hit.
#if OFFSET_SCHEME == 1
#define T_MIN 0.001
#else
#define T_MIN 0.0
#endif

struct Camera {
    vec3 eye;
    vec3 u;  // right
    vec3 v;  // up
    vec3 n;  // backwards
    vec2 size;        // of the picture plane
    float planeDist;  // from the eye to the picture plane
    float lensRadius;
    float focusDist;  // distance in focus over planeDist
    float time0;
    float time1;
};

// A unit vector along v, or `otherwise` when v is too short to have a direction.
vec3 directionOr(vec3 v, vec3 otherwise)
{
    float length2 = dot(v, v);
    return length2 > 1.0e-12 ? v * inversesqrt(length2) : otherwise;
}

// From an orthonormal frame: right, up, backwards. planeDist is the distance to the target, fovy is in degrees, clamped
// to [0.01, 179], aperture is the lens diameter.
Camera createCameraFromVectors(vec3 eye, vec3 right, vec3 up, vec3 back, float planeDist, float fovy, float aspect,
                               float aperture, float focusDist, float time0, float time1)
{
    vec2 sc = sinCosTurn(clamp(fovy, 0.01, 179.0) * 0.00138888889);
    float height = (2.0 * planeDist) * (sc.x / sc.y);
    return Camera(eye, right, up, back, vec2(aspect * height, height), planeDist, 0.5 * aperture, focusDist, time0,
                  time1);
}

// An up vector along the view is replaced by an axis that isn't, an eye at its target looks along -z.
Camera createCamera(vec3 eye, vec3 at, vec3 worldUp, float fovy, float aspect, float aperture, float focusDist,
                    float time0, float time1)
{
    vec3 back = eye - at;
    vec3 n = directionOr(back, vec3(0.0, 0.0, 1.0));
    vec3 spare = abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, -1.0);
    vec3 right = directionOr(cross(directionOr(worldUp, spare), n), normalize(cross(spare, n)));
    vec3 u = normalize(right - dot(right, n) * n);
    return createCameraFromVectors(eye, u, cross(n, u), n, max(length(back), 1.0e-6), fovy, aspect, aperture,
                                   focusDist, time0, time1);
}

// Orbit around `at`: azimuth in turns from +z towards +x, elevation in turns from straight below, and distance.
// Elevation must keep off 0 and 1/2, where up is undefined.
void GetCameraVectors(vec3 orbit, vec3 at, out vec3 cameraPos, out vec3 cameraFwd, out vec3 cameraUp,
                      out vec3 cameraRight)
{
    vec2 azimuth = sinCosTurn(fract(orbit.x));
    vec2 elevation = sinCosTurn(orbit.y);
    vec3 back = vec3(azimuth.x * elevation.x, -elevation.y, azimuth.y * elevation.x);
    cameraPos = at + orbit.z * back;
    cameraFwd = -back;
    cameraRight = vec3(azimuth.y, 0.0, -azimuth.x);
    cameraUp = cross(back, cameraRight);
}

// The scene's own view, as GetCameraVectors takes it.
#define CAMERA_ORBIT \
    vec4(CAMERA_AZIMUTH / 360.0, (90.0 + CAMERA_ELEVATION) / 360.0, CAMERA_DISTANCE, 0.0)

// Thin lens. pixel_sample is in [0, 1] x [0, 1] over the picture, xi is (lens, lens, shutter time).
Ray getRay(Camera cam, vec2 pixel_sample, vec3 xi)
{
    vec3 origin = cam.eye;
    vec2 target = (pixel_sample - 0.5) * cam.size * cam.focusDist;
    float time = cam.time0;
#ifdef HAS_LENS
    vec2 lens = cam.lensRadius * sampleDisk(xi.xy);
    origin = cam.eye - (lens.x * cam.u + lens.y * cam.v);
    target = target + lens;
#endif
#ifdef HAS_MOTION
    time = cam.time0 + xi.z * (cam.time1 - cam.time0);
#endif
    vec3 d = target.x * cam.u + (target.y * cam.v - (cam.planeDist * cam.focusDist) * cam.n);
    return createRay(origin, normalize(d), time);
}

//-------------------------------------------------------------------------------
// Materials
//-------------------------------------------------------------------------------

#define DIFFUSE 0
#define METAL 1       // mirror, made fuzzy by roughness
#define DIELECTRIC 2  // clear or coloured glass, made fuzzy by roughness
#define CONDUCTOR 3   // metal of GGX microfacets
#define PLASTIC 4     // diffuse under a gloss of GGX microfacets of index 1.5

struct Material {
    int type;
    vec3 albedo;        // diffuse reflectance
    vec3 specColor;     // reflectance at normal incidence
    vec3 edgeColor;     // tint towards grazing incidence (Gulbrandsen's g)
    vec3 emissive;      // radiance, from the side that the normal is on
    float roughness;    // [0, 1]; GGX alpha is its square
    float refIdx;       // [0.2, 5]
    vec3 refractColor;  // absorption per unit length, >= 0
};

// Arguments outside their range are clamped into it.
Material createDiffuseMaterial(vec3 albedo)
{
    return Material(DIFFUSE, clamp(albedo, 0.0, 1.0), vec3(0.0), vec3(1.0), vec3(0.0), 1.0, 1.0, vec3(0.0));
}

Material createLightMaterial(vec3 emissive)
{
    return Material(DIFFUSE, vec3(0.0), vec3(0.0), vec3(1.0), max(emissive, 0.0), 1.0, 1.0, vec3(0.0));
}

Material createMetalMaterial(vec3 specColor, float roughness)
{
    return Material(METAL, vec3(0.0), clamp(specColor, 0.0, 1.0), vec3(1.0), vec3(0.0), clamp(roughness, 0.0, 1.0), 1.0,
                    vec3(0.0));
}

Material createDielectricMaterial(vec3 refractColor, float refIdx, float roughness)
{
    return Material(DIELECTRIC, vec3(0.0), vec3(1.0), vec3(1.0), vec3(0.0), clamp(roughness, 0.0, 1.0),
                    clamp(refIdx, 0.2, 5.0), max(refractColor, 0.0));
}

Material createConductorMaterial(vec3 specColor, vec3 edgeColor, float roughness)
{
    return Material(CONDUCTOR, vec3(0.0), clamp(specColor, 0.0, 1.0), clamp(edgeColor, 0.0, 1.0), vec3(0.0),
                    clamp(roughness, 0.0, 1.0), 1.0, vec3(0.0));
}

Material createPlasticMaterial(vec3 albedo, float roughness)
{
    return Material(PLASTIC, clamp(albedo, 0.0, 1.0), vec3(0.04), vec3(1.0), vec3(0.0), clamp(roughness, 0.0, 1.0), 1.5,
                    vec3(0.0));
}

struct HitRecord {
    vec3 pos;
    vec3 normal;  // outwards, of unit length; a negative radius turns it inwards
    float t;
    float error;  // how far pos may stand from the surface, and a ray from pos see it
    Material material;
    int light;  // number of the quad light that was hit, or -1
};

// Eight roundings: bounds a few sums and products when multiplied by the sizes of what they add up.
#define ROUNDINGS 4.76837158e-7

// A ray that leaves a hit on the side of its surface that d points to.
Ray spawnRay(HitRecord rec, vec3 d, float time)
{
    vec3 side = dot(d, rec.normal) < 0.0 ? -rec.normal : rec.normal;
    return Ray(offsetPoint(rec.pos, side, rec.error), d, rec.pos, time);
}

//-------------------------------------------------------------------------------
// Fresnel
//-------------------------------------------------------------------------------

float pow5(float x)
{
    float x2 = x * x;
    return (x2 * x2) * x;
}

// Schlick 1994, "An Inexpensive BRDF Model". From a medium of index etaI into one of etaT; cosine is that of the angle
// on the incident side, clamped to [0, 1]. The cosine that counts is that of the thinner medium's side.
float schlick(float cosine, float etaI, float etaT)
{
    float c = clamp(cosine, 0.0, 1.0);
    float ratio = (etaI - etaT) / (etaI + etaT);
    float r0 = ratio * ratio;
#if FRESNEL != 2
    if (etaI > etaT) {
        float eta = etaI / etaT;
        float sin2 = (eta * eta) * ((1.0 - c) * (1.0 + c));
        if (sin2 >= 1.0) {
            return 1.0;
        }
        c = sqrt(1.0 - sin2);
    }
    if (etaI == etaT) {
        return 0.0;
    }
#endif
    return r0 + (1.0 - r0) * pow5(1.0 - c);
}

// Fresnel's equations, unpolarised light, dielectrics. 1 beyond the critical angle. g is etaT cos_t / etaI. Its square,
// eta^2 - sin^2, is taken from the smaller of sine and cosine: the other form would cancel.
float fresnelDielectric(float cosine, float etaI, float etaT)
{
    if (etaI == etaT) {
        return 0.0;
    }
    float c = clamp(cosine, 0.0, 1.0);
    float eta = etaT / etaI;
    float eta2 = eta * eta;
    float g2 = c > 0.7 ? eta2 - (1.0 - c) * (1.0 + c) : c * c + ((etaT - etaI) * (etaT + etaI)) / (etaI * etaI);
    if (!(g2 > 0.0)) {
        return 1.0;
    }
    float g = sqrt(g2);
    float rs = (c - g) / (c + g);
    float rp = (eta2 * c - g) / (eta2 * c + g);
    return 0.5 * (rs * rs + rp * rp);
}

float fresnelReflectance(float cosine, float etaI, float etaT)
{
#if FRESNEL == 0
    return fresnelDielectric(cosine, etaI, etaT);
#else
    return schlick(cosine, etaI, etaT);
#endif
}

// Schlick's approximation from the reflectance at normal incidence (the report's equation 5).
vec3 F_Schlick(vec3 F0, float VoH)
{
    return F0 + (1.0 - F0) * pow5(1.0 - clamp(VoH, 0.0, 1.0));
}

// Fresnel's equations, unpolarised light, from air into a metal of complex index eta + i k.
// The squares are what it takes, so that no square root is squared.
vec3 fresnelConductor(float cosine, vec3 eta2, vec3 k2)
{
    float c = clamp(cosine, 0.0, 1.0);
    float c2 = c * c;
    float s2 = 1.0 - c2;
    vec3 difference = (eta2 - k2) - s2;
    vec3 modulus = sqrt(difference * difference + 4.0 * (eta2 * k2));
    vec3 root = sqrt(max(0.5 * (modulus + difference), 0.0));
    vec3 sum1 = modulus + c2;
    vec3 product1 = (2.0 * c) * root;
    vec3 rs = (sum1 - product1) / max(sum1 + product1, 1.0e-30);
    vec3 sum2 = c2 * modulus + s2 * s2;
    vec3 product2 = product1 * s2;
    vec3 rp = (sum2 - product2) / (sum2 + product2);
    return clamp(0.5 * (rs + rs * rp), 0.0, 1.0);
}

// Gulbrandsen 2014, "Artist Friendly Metallic Fresnel" (JCGT 3(4)): the complex index that has the reflectance F0 at
// normal incidence and the tint `edge` near 80 degrees.
vec3 F_Gulbrandsen(vec3 F0, vec3 edge, float VoH)
{
    vec3 r = clamp(F0, 0.0, 0.999);
    vec3 root = sqrt(r);
    vec3 eta = (1.0 - edge) * ((1.0 + root) / (1.0 - root)) + edge * ((1.0 - r) / (1.0 + r));
    vec3 above = eta + 1.0;
    vec3 below = eta - 1.0;
    vec3 k2 = (r * (above * above) - below * below) / (1.0 - r);
    return fresnelConductor(VoH, eta * eta, max(k2, 0.0));
}

vec3 fresnelMetal(vec3 F0, vec3 edge, float VoH)
{
#if FRESNEL == 0
    return F_Gulbrandsen(F0, edge, VoH);
#else
    return F_Schlick(F0, VoH);
#endif
}

// Beer and Lambert: what is left after length d in a medium that absorbs sigma per unit length. 0 beyond 87.
vec3 transmittance(vec3 sigma, float d)
{
    vec3 y = (-1.44269504 * d) * sigma;
    return vec3(y.x < -126.0 ? 0.0 : portableExp2(y.x), y.y < -126.0 ? 0.0 : portableExp2(y.y),
                y.z < -126.0 ? 0.0 : portableExp2(y.z));
}

//-------------------------------------------------------------------------------
// Microfacets. Directions are in the frame of the normal: z is the cosine.
//-------------------------------------------------------------------------------

// Below it a surface is a mirror: the lobe is narrower than its own rounding errors.
#define ALPHA_MIN 0.001

float alphaOf(float roughness)
{
    return roughness * roughness;
}

// Trowbridge and Reitz 1975; Walter et al. 2007 (the report's equation 6). The denominator is written without
// 1 - h.z^2, which loses 12 % at alpha = 0.001.
float D_GGX(vec3 h, float alpha)
{
    float a2 = alpha * alpha;
    float d = a2 * (h.z * h.z) + dot(h.xy, h.xy);
    return a2 / ((PI * d) * d);
}

float smithRoot(float NoX, float alpha)
{
    float a2 = alpha * alpha;
    return sqrt(a2 + (1.0 - a2) * (NoX * NoX));
}

// Walter et al. 2007, equation 34.
float G1_GGX(float NoX, float alpha)
{
    return (2.0 * NoX) / (NoX + smithRoot(NoX, alpha));
}

// The report's equation 8.
float G1_SchlickGGX(float NoX, float alpha)
{
    float k = 0.5 * alpha;
    return NoX / (NoX * (1.0 - k) + k);
}

// Heitz 2014, "Understanding the Masking-Shadowing Function" (JCGT 3(2)), equation 99, over 4 NoL NoV.
float V_SmithGGXCorrelated(float NoV, float NoL, float alpha)
{
    return 0.5 / (NoL * smithRoot(NoV, alpha) + NoV * smithRoot(NoL, alpha));
}

float V_SmithGGX(float NoV, float NoL, float alpha)
{
    return 1.0 / ((NoV + smithRoot(NoV, alpha)) * (NoL + smithRoot(NoL, alpha)));
}

float V_SmithSchlickGGX(float NoV, float NoL, float alpha)
{
    return (G1_SchlickGGX(NoL, alpha) * G1_SchlickGGX(NoV, alpha)) / ((4.0 * NoL) * NoV);
}

float V_Smith(float NoV, float NoL, float alpha)
{
#if MASKING == 0
    return V_SmithGGXCorrelated(NoV, NoL, alpha);
#elif MASKING == 1
    return V_SmithGGX(NoV, NoL, alpha);
#else
    return V_SmithSchlickGGX(NoV, NoL, alpha);
#endif
}

// The specular BRDF times cosine, Fresnel aside. Never negative; max also keeps Mesa from rebalancing its factors with
// the caller's.
float specularLobe(vec3 v, vec3 l, vec3 h, float alpha)
{
    return max(D_GGX(h, alpha) * (l.z * V_Smith(v.z, l.z, alpha)), 0.0);
}

// Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps".
vec3 sampleVisibleNormal(vec3 v, float alpha, vec2 xi)
{
    vec3 stretched = normalize(vec3(alpha * v.xy, v.z));
    float z = (1.0 - xi.y) - xi.y * stretched.z;
    float r = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    vec2 sc = sinCosTurn(xi.x);
    vec3 h = vec3(r * sc.y, r * sc.x, z) + stretched;
    return normalize(vec3(alpha * h.xy, max(h.z, 1.0e-7)));
}

// Walter et al. 2007, equations 35 and 36: density D cos.
vec3 sampleNormal(float alpha, vec2 xi)
{
    float tan2 = (alpha * alpha) * (xi.y / (1.0 - xi.y));
    float z = 1.0 / sqrt(1.0 + tan2);
    float r = sqrt(tan2) * z;
    vec2 sc = sinCosTurn(xi.x);
    return vec3(r * sc.y, r * sc.x, z);
}

vec3 sampleMicrofacet(vec3 v, float alpha, vec2 xi)
{
#if SPECULAR_SAMPLING == 1
    return sampleNormal(alpha, xi);
#else
    return sampleVisibleNormal(v, alpha, xi);
#endif
}

// Density per solid angle of the mirror direction l, with the Jacobian 1 / (4 VoH) of the reflection.
float pdfMicrofacet(vec3 v, vec3 h, float VoH, float alpha)
{
#if SPECULAR_SAMPLING == 1
    return (D_GGX(h, alpha) * h.z) / (4.0 * VoH);
#else
    return D_GGX(h, alpha) / (2.0 * (v.z + smithRoot(v.z, alpha)));
#endif
}

//-------------------------------------------------------------------------------
// Directional albedo of the lobes above, height-correlated Smith. By quadrature over visible normals; the tables are
// fitted from above, so that no furnace shines. tools/albedo_tables.cpp prints them. For cosines over 0.1 the first is
// at worst 0.05 % below the truth and 0.3 % above it, the second 0.06 % and 1.3 %; towards 0 up to 0.1 % below it.
// Rows: roughness 0 to 1 in 31 steps. Columns: square root of the cosine, 0 to 1 in 15 steps.
//-------------------------------------------------------------------------------

#ifdef HAS_CONDUCTOR
// F = 1.
const float GGX_ALBEDO[512] = float[512](
    0.9982, 0.9733, 1.0363, 0.9997, 1.0016, 0.9999, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000,
    1.0000, 1.0000, 1.0000, 0.9965, 0.9697, 1.0394, 0.9993, 1.0016, 0.9999, 1.0002, 1.0001, 1.0000, 1.0000,
    1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0182, 0.8918, 0.9744, 1.0064, 0.9986, 1.0000, 0.9996,
    1.0000, 0.9999, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0308, 0.9242, 0.9098, 0.9819,
    0.9917, 0.9970, 0.9988, 0.9993, 0.9997, 0.9999, 0.9999, 1.0000, 1.0001, 1.0003, 1.0003, 1.0001, 1.0143,
    0.9585, 0.8910, 0.9271, 0.9763, 0.9877, 0.9948, 0.9969, 0.9982, 0.9989, 0.9992, 0.9994, 0.9995, 0.9996,
    0.9998, 0.9999, 1.0091, 0.9730, 0.9026, 0.8976, 0.9387, 0.9701, 0.9858, 0.9919, 0.9953, 0.9970, 0.9979,
    0.9986, 0.9987, 0.9992, 0.9994, 0.9991, 1.0056, 0.9814, 0.9207, 0.8901, 0.9087, 0.9443, 0.9696, 0.9825,
    0.9896, 0.9933, 0.9955, 0.9968, 0.9977, 0.9981, 0.9986, 0.9989, 1.0044, 0.9858, 0.9364, 0.8955, 0.8923,
    0.9172, 0.9472, 0.9679, 0.9802, 0.9873, 0.9913, 0.9938, 0.9954, 0.9964, 0.9972, 0.9977, 1.0034, 0.9888,
    0.9483, 0.9061, 0.8874, 0.8981, 0.9233, 0.9489, 0.9662, 0.9774, 0.9844, 0.9888, 0.9915, 0.9934, 0.9945,
    0.9957, 1.0028, 0.9906, 0.9568, 0.9168, 0.8895, 0.8869, 0.9035, 0.9271, 0.9486, 0.9640, 0.9745, 0.9812,
    0.9858, 0.9888, 0.9909, 0.9925, 1.0024, 0.9917, 0.9625, 0.9257, 0.8947, 0.8818, 0.8885, 0.9069, 0.9286,
    0.9472, 0.9611, 0.9710, 0.9777, 0.9824, 0.9854, 0.9879, 1.0021, 0.9925, 0.9667, 0.9330, 0.9009, 0.8809,
    0.8782, 0.8897, 0.9083, 0.9280, 0.9446, 0.9574, 0.9667, 0.9733, 0.9780, 0.9815, 1.0019, 0.9929, 0.9694,
    0.9384, 0.9062, 0.8821, 0.8718, 0.8757, 0.8895, 0.9076, 0.9254, 0.9405, 0.9523, 0.9612, 0.9678, 0.9727,
    1.0018, 0.9930, 0.9709, 0.9416, 0.9102, 0.8837, 0.8679, 0.8646, 0.8726, 0.8873, 0.9045, 0.9208, 0.9347,
    0.9459, 0.9545, 0.9610, 1.0018, 0.9930, 0.9716, 0.9437, 0.9126, 0.8848, 0.8648, 0.8558, 0.8577, 0.8678,
    0.8826, 0.8987, 0.9138, 0.9268, 0.9375, 0.9459, 1.0018, 0.9929, 0.9716, 0.9445, 0.9138, 0.8849, 0.8619,
    0.8480, 0.8442, 0.8493, 0.8606, 0.8750, 0.8904, 0.9047, 0.9173, 0.9275, 1.0018, 0.9927, 0.9709, 0.9439,
    0.9133, 0.8837, 0.8585, 0.8406, 0.8316, 0.8316, 0.8386, 0.8503, 0.8644, 0.8789, 0.8926, 0.9045, 1.0019,
    0.9923, 0.9701, 0.9427, 0.9117, 0.8812, 0.8540, 0.8328, 0.8195, 0.8144, 0.8168, 0.8249, 0.8367, 0.8505,
    0.8644, 0.8776, 1.0019, 0.9919, 0.9687, 0.9406, 0.9087, 0.8773, 0.8484, 0.8244, 0.8071, 0.7974, 0.7950,
    0.7990, 0.8077, 0.8193, 0.8324, 0.8459, 1.0021, 0.9913, 0.9669, 0.9376, 0.9049, 0.8721, 0.8415, 0.8150,
    0.7942, 0.7802, 0.7732, 0.7726, 0.7774, 0.7863, 0.7977, 0.8102, 1.0022, 0.9907, 0.9648, 0.9343, 0.9000,
    0.8658, 0.8332, 0.8043, 0.7804, 0.7625, 0.7511, 0.7459, 0.7464, 0.7516, 0.7601, 0.7711, 1.0023, 0.9900,
    0.9626, 0.9304, 0.8943, 0.8583, 0.8238, 0.7925, 0.7656, 0.7441, 0.7284, 0.7188, 0.7148, 0.7157, 0.7208,
    0.7289, 1.0025, 0.9892, 0.9599, 0.9258, 0.8878, 0.8498, 0.8132, 0.7794, 0.7497, 0.7248, 0.7053, 0.6913,
    0.6827, 0.6791, 0.6799, 0.6844, 1.0027, 0.9884, 0.9571, 0.9210, 0.8807, 0.8405, 0.8015, 0.7653, 0.7327,
    0.7046, 0.6814, 0.6632, 0.6502, 0.6420, 0.6383, 0.6385, 1.0028, 0.9875, 0.9542, 0.9157, 0.8730, 0.8303,
    0.7889, 0.7501, 0.7148, 0.6836, 0.6569, 0.6348, 0.6176, 0.6048, 0.5964, 0.5921, 1.0030, 0.9866, 0.9509,
    0.9100, 0.8647, 0.8194, 0.7755, 0.7340, 0.6959, 0.6617, 0.6317, 0.6061, 0.5849, 0.5679, 0.5550, 0.5459,
    1.0032, 0.9856, 0.9475, 0.9041, 0.8560, 0.8080, 0.7613, 0.7171, 0.6762, 0.6391, 0.6061, 0.5772, 0.5523,
    0.5314, 0.5143, 0.5009, 1.0033, 0.9846, 0.9442, 0.8979, 0.8468, 0.7960, 0.7464, 0.6995, 0.6559, 0.6161,
    0.5801, 0.5482, 0.5200, 0.4957, 0.4748, 0.4572, 1.0035, 0.9835, 0.9403, 0.8914, 0.8374, 0.7835, 0.7311,
    0.6814, 0.6351, 0.5926, 0.5540, 0.5192, 0.4883, 0.4609, 0.4368, 0.4159, 1.0038, 0.9824, 0.9366, 0.8846,
    0.8276, 0.7707, 0.7154, 0.6629, 0.6139, 0.5689, 0.5278, 0.4906, 0.4572, 0.4272, 0.4005, 0.3768, 1.0041,
    0.9813, 0.9327, 0.8778, 0.8175, 0.7575, 0.6993, 0.6441, 0.5926, 0.5451, 0.5017, 0.4624, 0.4269, 0.3949,
    0.3662, 0.3403, 1.0044, 0.9801, 0.9286, 0.8708, 0.8071, 0.7441, 0.6830, 0.6251, 0.5711, 0.5214, 0.4760,
    0.4349, 0.3976, 0.3641, 0.3339, 0.3069);

float ggxAlbedo(float NoV, float roughness)
{
    vec2 at = vec2(15.0 * sqrt(clamp(NoV, 0.0, 1.0)), 31.0 * clamp(roughness, 0.0, 1.0));
    ivec2 cell = min(ivec2(at), ivec2(14, 30));
    vec2 f = at - vec2(cell);
    int i = cell.y * 16 + cell.x;
    return lerp(lerp(GGX_ALBEDO[i], GGX_ALBEDO[i + 1], f.x), lerp(GGX_ALBEDO[i + 16], GGX_ALBEDO[i + 17], f.x), f.y);
}

// Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models", equation 16.
vec3 energyCompensation(vec3 F0, float NoV, float roughness)
{
#if ENERGY_COMPENSATION == 1
    float E = ggxAlbedo(NoV, roughness);
    return 1.0 + F0 * ((1.0 - E) / E);
#else
    return vec3(1.0);
#endif
}
#endif

#ifdef HAS_PLASTIC
// Index 1.5, over the Fresnel reflectance at the same cosine.
const float GLOSS_ALBEDO[512] = float[512](
    0.9687, 0.9681, 1.0360, 0.9991, 1.0012, 0.9997, 0.9999, 0.9999, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000,
    1.0000, 1.0000, 1.0000, 0.9664, 0.9675, 1.0443, 0.9989, 1.0023, 0.9999, 1.0003, 1.0000, 1.0000, 1.0000,
    1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 1.0000, 0.9166, 0.8494, 0.9780, 0.9933, 0.9962, 0.9978, 0.9986,
    0.9993, 0.9998, 1.0000, 1.0003, 1.0002, 1.0002, 1.0001, 1.0000, 1.0000, 0.8521, 0.8062, 0.8515, 0.9561,
    0.9774, 0.9879, 0.9934, 0.9962, 0.9982, 0.9996, 1.0004, 1.0010, 1.0013, 1.0013, 1.0008, 1.0000, 0.7639,
    0.7572, 0.7676, 0.8544, 0.9337, 0.9627, 0.9797, 0.9876, 0.9938, 0.9976, 1.0002, 1.0017, 1.0020, 1.0015,
    1.0009, 1.0001, 0.6898, 0.6893, 0.7017, 0.7630, 0.8542, 0.9153, 0.9519, 0.9711, 0.9846, 0.9931, 0.9994,
    1.0029, 1.0043, 1.0037, 1.0016, 0.9991, 0.6200, 0.6240, 0.6395, 0.6849, 0.7643, 0.8460, 0.9052, 0.9423,
    0.9672, 0.9843, 0.9963, 1.0039, 1.0068, 1.0058, 1.0028, 0.9995, 0.5556, 0.5611, 0.5788, 0.6165, 0.6825,
    0.7653, 0.8418, 0.8995, 0.9401, 0.9692, 0.9898, 1.0031, 1.0093, 1.0088, 1.0038, 0.9986, 0.4969, 0.5028,
    0.5211, 0.5549, 0.6107, 0.6864, 0.7694, 0.8429, 0.9010, 0.9451, 0.9775, 0.9996, 1.0109, 1.0111, 1.0042,
    0.9972, 0.4442, 0.4500, 0.4676, 0.4986, 0.5470, 0.6146, 0.6949, 0.7773, 0.8504, 0.9110, 0.9582, 0.9918,
    1.0100, 1.0125, 1.0044, 0.9946, 0.3973, 0.4026, 0.4191, 0.4475, 0.4904, 0.5503, 0.6256, 0.7091, 0.7927,
    0.8678, 0.9309, 0.9784, 1.0062, 1.0127, 1.0037, 0.9909, 0.3558, 0.3607, 0.3757, 0.4016, 0.4401, 0.4934,
    0.5624, 0.6438, 0.7312, 0.8177, 0.8953, 0.9579, 0.9977, 1.0099, 1.0010, 0.9855, 0.3194, 0.3237, 0.3372,
    0.3607, 0.3953, 0.4432, 0.5059, 0.5829, 0.6705, 0.7633, 0.8532, 0.9303, 0.9833, 1.0033, 0.9958, 0.9779,
    0.2875, 0.2913, 0.3034, 0.3246, 0.3558, 0.3989, 0.4558, 0.5276, 0.6131, 0.7079, 0.8064, 0.8965, 0.9628,
    0.9919, 0.9871, 0.9676, 0.2597, 0.2630, 0.2738, 0.2928, 0.3210, 0.3599, 0.4117, 0.4781, 0.5598, 0.6546,
    0.7573, 0.8575, 0.9365, 0.9755, 0.9745, 0.9541, 0.2355, 0.2384, 0.2479, 0.2650, 0.2904, 0.3257, 0.3728,
    0.4341, 0.5112, 0.6041, 0.7082, 0.8152, 0.9051, 0.9543, 0.9581, 0.9374, 0.2145, 0.2169, 0.2254, 0.2406,
    0.2636, 0.2957, 0.3387, 0.3952, 0.4676, 0.5571, 0.6609, 0.7714, 0.8694, 0.9275, 0.9365, 0.9162, 0.1962,
    0.1983, 0.2058, 0.2194, 0.2402, 0.2693, 0.3087, 0.3609, 0.4287, 0.5140, 0.6159, 0.7273, 0.8306, 0.8958,
    0.9100, 0.8909, 0.1803, 0.1822, 0.1887, 0.2010, 0.2197, 0.2462, 0.2823, 0.3306, 0.3939, 0.4749, 0.5736,
    0.6840, 0.7902, 0.8605, 0.8789, 0.8608, 0.1666, 0.1681, 0.1739, 0.1848, 0.2017, 0.2260, 0.2591, 0.3037,
    0.3629, 0.4394, 0.5343, 0.6422, 0.7488, 0.8222, 0.8438, 0.8264, 0.1547, 0.1559, 0.1609, 0.1707, 0.1860,
    0.2081, 0.2386, 0.2800, 0.3351, 0.4073, 0.4978, 0.6023, 0.7074, 0.7818, 0.8053, 0.7885, 0.1443, 0.1453,
    0.1496, 0.1584, 0.1723, 0.1924, 0.2205, 0.2588, 0.3103, 0.3782, 0.4642, 0.5644, 0.6666, 0.7402, 0.7640,
    0.7466, 0.1353, 0.1360, 0.1398, 0.1476, 0.1601, 0.1786, 0.2044, 0.2399, 0.2879, 0.3517, 0.4330, 0.5285,
    0.6267, 0.6980, 0.7208, 0.7026, 0.1275, 0.1280, 0.1311, 0.1381, 0.1495, 0.1663, 0.1902, 0.2230, 0.2678,
    0.3276, 0.4042, 0.4946, 0.5877, 0.6555, 0.6764, 0.6567, 0.1207, 0.1209, 0.1236, 0.1297, 0.1400, 0.1554,
    0.1774, 0.2079, 0.2496, 0.3055, 0.3775, 0.4625, 0.5504, 0.6138, 0.6318, 0.6101, 0.1147, 0.1148, 0.1169,
    0.1223, 0.1316, 0.1457, 0.1660, 0.1942, 0.2330, 0.2852, 0.3525, 0.4321, 0.5144, 0.5726, 0.5872, 0.5635,
    0.1095, 0.1094, 0.1110, 0.1158, 0.1241, 0.1371, 0.1557, 0.1818, 0.2178, 0.2664, 0.3292, 0.4034, 0.4796,
    0.5327, 0.5436, 0.5177, 0.1050, 0.1046, 0.1059, 0.1099, 0.1174, 0.1292, 0.1464, 0.1706, 0.2040, 0.2491,
    0.3075, 0.3762, 0.4464, 0.4941, 0.5012, 0.4733, 0.1011, 0.1005, 0.1013, 0.1048, 0.1115, 0.1222, 0.1379,
    0.1603, 0.1912, 0.2331, 0.2870, 0.3506, 0.4147, 0.4570, 0.4605, 0.4309, 0.0976, 0.0968, 0.0972, 0.1001,
    0.1061, 0.1158, 0.1303, 0.1509, 0.1795, 0.2182, 0.2680, 0.3263, 0.3845, 0.4215, 0.4217, 0.3908, 0.0946,
    0.0935, 0.0935, 0.0959, 0.1012, 0.1100, 0.1232, 0.1422, 0.1686, 0.2042, 0.2500, 0.3034, 0.3559, 0.3878,
    0.3850, 0.3533, 0.0919, 0.0906, 0.0903, 0.0921, 0.0967, 0.1047, 0.1168, 0.1342, 0.1585, 0.1913, 0.2332,
    0.2818, 0.3288, 0.3558, 0.3505, 0.3187);

// Mean over the hemisphere, cosine-weighted.
const float GLOSS_MEAN[32] = float[32](
    0.0918, 0.0918, 0.0917, 0.0913, 0.0906, 0.0894, 0.0878, 0.0857, 0.0832, 0.0805, 0.0774, 0.0742, 0.0709,
    0.0675, 0.0642, 0.0608, 0.0575, 0.0543, 0.0512, 0.0482, 0.0453, 0.0425, 0.0398, 0.0372, 0.0348, 0.0324,
    0.0302, 0.0281, 0.0261, 0.0242, 0.0224, 0.0208);

float glossAlbedo(float NoV, float roughness)
{
    vec2 at = vec2(15.0 * sqrt(clamp(NoV, 0.0, 1.0)), 31.0 * clamp(roughness, 0.0, 1.0));
    ivec2 cell = min(ivec2(at), ivec2(14, 30));
    vec2 f = at - vec2(cell);
    int i = cell.y * 16 + cell.x;
    float ratio =
        lerp(lerp(GLOSS_ALBEDO[i], GLOSS_ALBEDO[i + 1], f.x), lerp(GLOSS_ALBEDO[i + 16], GLOSS_ALBEDO[i + 17], f.x), f.y);
    return min(ratio * fresnelDielectric(NoV, 1.0, 1.5), 1.0);
}

float glossMean(float roughness)
{
    float at = 31.0 * clamp(roughness, 0.0, 1.0);
    int i = min(int(at), 30);
    return lerp(GLOSS_MEAN[i], GLOSS_MEAN[i + 1], at - float(i));
}
#endif

//-------------------------------------------------------------------------------
// Scattering
//-------------------------------------------------------------------------------

// Lambert. The cosine and pi of the estimator cancel against the density of the directions.
vec3 diffuseAttenuation(vec3 albedo, float NoL)
{
#if SEED_ATTENUATION == 0
    return albedo;
#else
    return albedo * NoL;
#endif
}

// Directions in the frame of n have z along it.
vec3 toLocal(mat3 basis, vec3 v)
{
    return vec3(dot(basis[0], v), dot(basis[1], v), dot(basis[2], v));
}

// Can light from a given direction be weighed: has the material a density of directions?
bool isSampleable(Material m)
{
#ifdef HAS_CONDUCTOR
    if (m.type == CONDUCTOR) {
        return SPECULAR_SAMPLING != 2 && alphaOf(m.roughness) >= ALPHA_MIN;
    }
#endif
    return m.type == DIFFUSE || m.type == PLASTIC;
}

#ifdef HAS_PLASTIC
// The chance to follow the gloss: its share of the light that leaves.
float glossProbability(Material m, float NoV)
{
#if SPECULAR_SAMPLING == 2
    float gloss = F_Schlick(m.specColor, NoV).x;
#else
    float E = glossAlbedo(NoV, m.roughness);
    float base = (1.0 - E) * (0.333333333 * (m.albedo.r + (m.albedo.g + m.albedo.b)));
    float gloss = E / (E + base);
#endif
    return clamp(gloss, 0.05, 0.95);
}

// What comes up through the gloss, over albedo / pi.
float plasticDiffuse(Material m, float NoV, float NoL)
{
#if PLASTIC_DIFFUSE == 0
    // Kelemen and Szirmay-Kalos 2001: in proportion to what the gloss leaves over, both ways.
    float enters = 1.0 - glossAlbedo(NoL, m.roughness);
    float leaves = 1.0 - glossAlbedo(NoV, m.roughness);
    return (enters * leaves) / (1.0 - glossMean(m.roughness));
#elif PLASTIC_DIFFUSE == 1
    return (1.0 - fresnelReflectance(NoL, 1.0, m.refIdx)) * (1.0 - fresnelReflectance(NoV, 1.0, m.refIdx));
#else
    return 1.0;
#endif
}
#endif

// BRDF times cosine, in the frame of the normal, and the density with which scatter chooses l. v and l point away from
// the surface.
vec3 evaluateLocal(Material m, vec3 v, vec3 l, inout float pdf)
{
    pdf = 0.0;
    if (!(v.z > 0.0 && l.z > 0.0)) {
        return vec3(0.0);
    }
#if defined(HAS_CONDUCTOR) || defined(HAS_PLASTIC)
    float alpha = max(alphaOf(m.roughness), ALPHA_MIN);
    vec3 h = normalize(v + l);
    float VoH = max(dot(v, h), 1.0e-7);
#endif
#ifdef HAS_CONDUCTOR
    if (m.type == CONDUCTOR) {
        pdf = pdfMicrofacet(v, h, VoH, alpha);
        vec3 F = fresnelMetal(m.specColor, m.edgeColor, VoH) * energyCompensation(m.specColor, v.z, m.roughness);
        return F * specularLobe(v, l, h, alpha);
    }
#endif
    float cosinePdf = l.z * INV_PI;
#ifdef HAS_PLASTIC
    if (m.type == PLASTIC) {
        float gloss = glossProbability(m, v.z);
        vec3 base = (cosinePdf * plasticDiffuse(m, v.z, l.z)) * m.albedo;
#if SPECULAR_SAMPLING == 2
        pdf = (1.0 - gloss) * cosinePdf;
        return base;
#else
        pdf = lerp(cosinePdf, pdfMicrofacet(v, h, VoH, alpha), gloss);
        float F = fresnelReflectance(VoH, 1.0, m.refIdx);
        return base + F * specularLobe(v, l, h, alpha);
#endif
    }
#endif
    pdf = cosinePdf;
    return cosinePdf * m.albedo;
}

// The same in the world. n is on the side of v.
vec3 evaluateBsdf(Material m, vec3 n, vec3 v, vec3 l, inout float pdf)
{
    mat3 basis = basisAround(n);
    return evaluateLocal(m, toLocal(basis, v), toLocal(basis, l), pdf);
}

// A perfect direction made fuzzy: a point of a ball of radius roughness around its tip. No density is known.
vec3 fuzz(vec3 d, float roughness, vec3 xi)
{
    return directionOr(d + roughness * sampleBall(xi), d);
}

// Of two that meet at a surface, the next ray and what it carries. False when the path ends (absorbed).
// xi: (direction, direction, lobe), and the ball's radius. pdf is the density of the direction per solid angle, or 0
// where it has none (mirror, glass and their fuzzy versions), so that lights can't be sampled.
bool scatter(Ray rIn, HitRecord rec, vec4 xi, inout vec3 attenuation, inout Ray rScattered, inout float pdf)
{
    bool inside = dot(rIn.d, rec.normal) > 0.0;
    vec3 normal = inside ? -rec.normal : rec.normal;
    Material m = rec.material;
    pdf = 0.0;

#ifdef HAS_METAL
    if (m.type == METAL) {
        vec3 d = fuzz(reflect(rIn.d, normal), m.roughness, xi.xyw);
        attenuation = m.specColor;
        rScattered = spawnRay(rec, d, rIn.time);
        return dot(d, normal) > 0.0;
    }
#endif

#ifdef HAS_DIELECTRIC
    if (m.type == DIELECTRIC) {
        float etaI = inside ? m.refIdx : 1.0;
        float etaT = inside ? 1.0 : m.refIdx;
        float eta = etaI / etaT;
        float cosine = min(-dot(rIn.d, normal), 1.0);
        float F = fresnelReflectance(cosine, etaI, etaT);
        vec3 refracted = refract(rIn.d, normal, eta);
        bool reflects = xi.z < F || dot(refracted, refracted) == 0.0;
        vec3 perfect = normalize(reflects ? reflect(rIn.d, normal) : refracted);
        vec3 d = fuzz(perfect, m.roughness, xi.xyw);
        // A fuzzy direction that crosses to the wrong side falls back to the perfect one.
        float side = dot(d, normal);
        d = (reflects ? side > 0.0 : side < 0.0) ? d : perfect;
        attenuation = inside ? transmittance(m.refractColor, distance(rec.pos, rIn.from)) : vec3(1.0);
        rScattered = spawnRay(rec, d, rIn.time);
        return true;
    }
#endif

#if defined(HAS_CONDUCTOR) || defined(HAS_PLASTIC)
    if (m.type == CONDUCTOR || m.type == PLASTIC) {
        mat3 basis = basisAround(normal);
        vec3 v = toLocal(basis, -rIn.d);
        float alpha = alphaOf(m.roughness);
        float gloss = 1.0;
#ifdef HAS_PLASTIC
        if (m.type == PLASTIC) {
            alpha = max(alpha, ALPHA_MIN);
            gloss = glossProbability(m, v.z);
        }
#endif
        bool specular = xi.z < gloss;
        bool hasDensity = !specular || (SPECULAR_SAMPLING != 2 && alpha >= ALPHA_MIN);
        vec3 l = vec3(-v.x, -v.y, v.z);
        if (!specular) {
            vec2 p = sampleDisk(xi.xy);
            l = vec3(p, sqrt(max(0.0, 1.0 - dot(p, p))));
        } else if (hasDensity) {
            vec3 h = sampleMicrofacet(v, alpha, xi.xy);
            l = normalize(reflect(-v, h));
        } else if (alpha >= ALPHA_MIN) {
            l = fuzz(l, m.roughness, xi.xyw);
        }
        if (hasDensity) {
            vec3 f = evaluateLocal(m, v, l, pdf);
            if (!(pdf > 0.0)) {
                pdf = 0.0;
                return false;
            }
            attenuation = f / pdf;
        } else {
            vec3 F = m.type == PLASTIC ? F_Schlick(m.specColor, v.z) : fresnelMetal(m.specColor, m.edgeColor, v.z);
            attenuation = F / gloss;
        }
        rScattered = spawnRay(rec, normalize(toWorld(basis, l)), rIn.time);
        return l.z > 0.0;
    }
#endif

    vec3 d = sampleCosineHemisphere(normal, xi.xy);
    float NoL = max(dot(normal, d), 0.0);
    attenuation = diffuseAttenuation(m.albedo, NoL);
    rScattered = spawnRay(rec, d, rIn.time);
    pdf = NoL * INV_PI;
    return pdf > 0.0;
}

//-------------------------------------------------------------------------------
// Intersections. Each fills rec and returns true for a hit with tmin < t < tmax, else leaves rec as it was.
//-------------------------------------------------------------------------------

struct Triangle {
    vec3 a;
    vec3 b;
    vec3 c;
};

Triangle createTriangle(vec3 a, vec3 b, vec3 c)
{
    return Triangle(a, b, c);
}

// Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection" (JCGT 2(1)). The ray's longest axis becomes z
// and is sheared to (0, 0, 1): then an edge function has exactly the opposite value for the neighbour across that
// edge, and no ray slips between. Edges belong to both neighbours; a ray through one takes the first that it is given.
bool hit_triangle(Triangle tri, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    vec3 along = abs(r.d);
    bool zLongest = along.z >= along.x && along.z >= along.y;
    bool yLongest = !zLongest && along.y >= along.x;
    vec3 a = tri.a - r.o;
    vec3 b = tri.b - r.o;
    vec3 c = tri.c - r.o;
    vec3 d = r.d;
    if (yLongest) {
        a = a.zxy;
        b = b.zxy;
        c = c.zxy;
        d = d.zxy;
    } else if (!zLongest) {
        a = a.yzx;
        b = b.yzx;
        c = c.yzx;
        d = d.yzx;
    }
    vec2 shear = d.xy / d.z;
    a.xy = a.xy - a.z * shear;
    b.xy = b.xy - b.z * shear;
    c.xy = c.xy - c.z * shear;
    float u = c.x * b.y - c.y * b.x;
    float v = a.x * c.y - a.y * c.x;
    float w = b.x * a.y - b.y * a.x;
    bool outside = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
    float det = u + (v + w);
    if (outside || det == 0.0) {
        return false;
    }
    float t = (dot(vec3(u, v, w), vec3(a.z, b.z, c.z)) / det) / d.z;
    if (!(t > tmin && t < tmax)) {
        return false;
    }
    vec3 edge1 = tri.b - tri.a;
    vec3 edge2 = tri.c - tri.a;
    vec3 normal = cross(edge1, edge2);
    if (dot(normal, normal) == 0.0) {
        return false;
    }
    rec.t = t;
    rec.pos = ((u / det) * tri.a + (v / det) * tri.b) + (w / det) * tri.c;
    rec.normal = normalize(normal);
    // The rounding of the plane, and that of a t worked out along another axis.
    rec.error = ROUNDINGS * (max3(max(abs(edge1), abs(edge2))) + dot(abs(rec.normal), abs(rec.pos)));
    return true;
}

// A parallelogram: a corner and the two edges that leave it. Its normal is edge1 x edge2.
struct Quad {
    vec3 corner;
    vec3 edge1;
    vec3 edge2;
};

Quad createQuad(vec3 corner, vec3 edge1, vec3 edge2)
{
    return Quad(corner, edge1, edge2);
}

// The t in (tmin, tmax) of a hit, or tmax when there is none. One plane, one pair of coordinates in [0, 1] along the
// edges: no diagonal, so no crack. The dual edges fold to constants when the quad is one.
float quadRoot(Quad quad, Ray r, float tmin, float tmax)
{
    vec3 n = cross(quad.edge1, quad.edge2);
    float n2 = dot(n, n);
    float slope = dot(r.d, n);
    if (slope == 0.0 || n2 == 0.0) {
        return tmax;
    }
    vec3 toOrigin = r.o - quad.corner;
    float t = -dot(toOrigin, n) / slope;
    vec3 dual1 = cross(quad.edge2, n) / n2;
    vec3 dual2 = cross(n, quad.edge1) / n2;
    vec3 p = toOrigin + t * r.d;
    float a = dot(p, dual1);
    float b = dot(p, dual2);
    bool within = a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0;
    return within && t > tmin && t < tmax ? t : tmax;
}

// The hit is moved back into the plane.
bool hit_quad(Quad quad, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    float t = quadRoot(quad, r, tmin, tmax);
    if (!(t < tmax)) {
        return false;
    }
    vec3 n = cross(quad.edge1, quad.edge2);
    vec3 p = (r.o - quad.corner) + t * r.d;
    rec.t = t;
    rec.normal = n / sqrt(dot(n, n));
    rec.pos = quad.corner + (p - dot(p, rec.normal) * rec.normal);
    rec.error = ROUNDINGS * dot(abs(rec.normal), abs(quad.corner) + abs(p));
    return true;
}

// A negative radius is a cavity: the same surface, its normal towards the centre.
struct Sphere {
    vec3 center;
    float radius;
};

Sphere createSphere(vec3 center, float radius)
{
    return Sphere(center, radius);
}

// Both roots of |o + t d| = radius, the nearer one first. False when there are none, or only one. o is relative to the
// centre.
bool sphereRoots(vec3 o, vec3 d, float radius, inout vec2 roots)
{
    float radius2 = radius * radius;
    float b = -dot(o, d);
    float c = dot(o, o) - radius2;
#if SPHERE_ROOT == 0
    // Haines et al. 2019 (Ray Tracing Gems, chapter 7): the discriminant from the closest approach, and the root
    // without cancellation first.
    vec3 closest = o + b * d;
    float discriminant = radius2 - dot(closest, closest);
    if (!(discriminant > 0.0)) {
        return false;
    }
    float s = sqrt(discriminant);
    float q = b >= 0.0 ? b + s : b - s;
    float other = c / q;
    roots = vec2(min(other, q), max(other, q));
#else
    float discriminant = b * b - c;
    if (!(discriminant > 0.0)) {
        return false;
    }
    float s = sqrt(discriminant);
    roots = vec2(b - s, b + s);
#endif
    return true;
}

// The nearest root in (tmin, tmax), or tmax when there is none.
float sphereRoot(vec3 o, vec3 d, float radius, float tmin, float tmax)
{
    vec2 roots = vec2(tmax);
    if (!sphereRoots(o, d, radius, roots)) {
        return tmax;
    }
    float t = roots.x > tmin ? roots.x : roots.y;
    return t > tmin && t < tmax ? t : tmax;
}

// The offset origin decides which root is hit; where it lies is taken from the point that the ray really left, so that
// refraction doesn't add the offsets up. The hit is moved back on to the sphere, where the next offset expects it.
bool hit_sphere(Sphere s, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    vec3 o = r.o - s.center;
    float t = sphereRoot(o, r.d, s.radius, tmin, tmax);
    if (!(t < tmax)) {
        return false;
    }
    vec3 p = o + t * r.d;
    vec3 from = r.from - s.center;
    vec2 roots = vec2(0.0);
    if (sphereRoots(from, r.d, s.radius, roots)) {
        p = from + (abs(roots.x - t) < abs(roots.y - t) ? roots.x : roots.y) * r.d;
    }
    vec3 n = normalize(p);
    rec.t = t;
    rec.pos = s.center + abs(s.radius) * n;
#if NEGATIVE_RADIUS == 0
    rec.normal = s.radius < 0.0 ? -n : n;
#else
    rec.normal = n;
#endif
    rec.error = ROUNDINGS * (dot(abs(n), abs(s.center)) + abs(s.radius));
    return true;
}

struct MovingSphere {
    vec3 center0;  // at time0
    vec3 center1;  // at time1
    float radius;
    float time0;
    float time1;
};

MovingSphere createMovingSphere(vec3 center0, vec3 center1, float radius, float time0, float time1)
{
    return MovingSphere(center0, center1, radius, time0, time1);
}

// The centre at a time, which is clamped to [time0, time1].
vec3 center(MovingSphere s, float time)
{
    float duration = s.time1 - s.time0;
    float f = duration > 0.0 ? clamp((time - s.time0) / duration, 0.0, 1.0) : 0.0;
    return s.center0 + f * (s.center1 - s.center0);
}

bool hit_movingSphere(MovingSphere s, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    return hit_sphere(createSphere(center(s, r.time), s.radius), r, tmin, tmax, rec);
}

//-------------------------------------------------------------------------------
// Lights
//-------------------------------------------------------------------------------

struct PointLight {
    vec3 pos;
    vec3 color;
    float intensity;  // radiant intensity of color 1
};

PointLight createPointLight(vec3 pos, vec3 color, float intensity)
{
    return PointLight(pos, color, intensity);
}

// A parallelogram that shines to the side of its normal, edge1 x edge2.
struct QuadLight {
    vec3 corner;
    vec3 edge1;
    vec3 edge2;
    vec3 color;   // radiance
    vec3 normal;
    float area;
};

QuadLight createQuadLight(Quad quad, vec3 color)
{
    vec3 n = cross(quad.edge1, quad.edge2);
    float area = length(n);
    return QuadLight(quad.corner, quad.edge1, quad.edge2, color, n / area, area);
}

// Uniform on the light.
vec3 sampleQuadLight(QuadLight ql, vec2 xi)
{
    return (ql.corner + xi.x * ql.edge1) + xi.y * ql.edge2;
}

// Density per solid angle of a uniform point, seen from a point at toLight's start. 0 from behind and edge on.
float pdfQuadLight(QuadLight ql, vec3 toLight)
{
    float distance2 = dot(toLight, toLight);
    float cosine = -dot(toLight, ql.normal);  // times the distance
    return cosine > 0.0 && distance2 > 1.0e-12 ? distance2 * sqrt(distance2) / (cosine * ql.area) : 0.0;
}

// Veach and Guibas 1995, power and balance heuristics: the weight of a direction that the first density chose.
float powerHeuristic(float pdf, float other)
{
    float ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}

float balanceHeuristic(float pdf, float other)
{
    return pdf / (pdf + other);
}
