// Path tracer, Common tab: random numbers, camera, materials, hit_*, scatter, BRDFs.
//
// Paste after a scene file. Alone it compiles with every feature on. Nothing here reads a uniform or a channel, so
// that each function can be called from a test, on any pass, and on a CPU.
//
// The arithmetic is shaped so that a CPU can repeat it bit for bit: no sin, cos, exp, log or pow built-ins, no product
// of three factors or sum of three terms that ends in a literal (Mesa moves the literal), no a*b + a*c (Mesa factors
// it), no chain of four.

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

// Where a spawned ray starts. 0: the next floats along the normal (Waechter and Binder), never hits its own surface.
// 1: 0.001 along the normal (the report's assignment), cheaper, fails away from unit scale.
#ifndef OFFSET_SCHEME
#define OFFSET_SCHEME 0
#endif

// Quadratic of the ray and sphere. 0: from the closest approach (Haines et al.), accurate far away. 1: textbook
// b*b - c: two dot products fewer, speckles from about 100 radii on.
#ifndef SPHERE_ROOT
#define SPHERE_ROOT 0
#endif

// Random numbers. 0: PCG4D keyed by pixel, sample and dimension. 1: the same, read as 16-bit fractions: a slightly
// cheaper conversion and 65,536 levels. 2: float seed that grows by 0.1 a draw and is hashed, as in the report's
// assignment, but keyed by the sample number and never by the time.
#ifndef RANDOM_NUMBERS
#define RANDOM_NUMBERS 0
#endif

// The report's own scatter weights. 0: physical. 1: diffuse attenuation albedo * cos (equation 3), a third too dark.
#ifndef SEED_ATTENUATION
#define SEED_ATTENUATION 0
#endif

#if FRESNEL < 0 || FRESNEL > 2
#error FRESNEL is 0 (exact), 1 (Schlick) or 2 (Schlick with the incident cosine)
#endif
#if OFFSET_SCHEME < 0 || OFFSET_SCHEME > 1
#error OFFSET_SCHEME is 0 (next floats) or 1 (fixed)
#endif
#if SPHERE_ROOT < 0 || SPHERE_ROOT > 1
#error SPHERE_ROOT is 0 (closest approach) or 1 (textbook)
#endif
#if RANDOM_NUMBERS < 0 || RANDOM_NUMBERS > 2
#error RANDOM_NUMBERS is 0 (PCG4D), 1 (PCG4D of 16 bits) or 2 (float seed)
#endif
#if SEED_ATTENUATION < 0 || SEED_ATTENUATION > 1
#error SEED_ATTENUATION is 0 (physical) or 1 (the report)
#endif

//-------------------------------------------------------------------------------
// Features: what the scene before this file doesn't declare is compiled out
//-------------------------------------------------------------------------------

#if !defined(SCENE_NAME) || defined(GENERAL)
#define HAS_LENS
#define HAS_MOTION
#define HAS_METAL
#define HAS_DIELECTRIC
#define HAS_POINT_LIGHTS
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

float max3(vec3 v)
{
    return max(max(v.x, v.y), v.z);
}

// False for NaN, infinities and whatever else a mean can't hold.
bool isPlausible(vec3 c)
{
    return all(greaterThanEqual(c, vec3(0.0))) && all(lessThan(c, vec3(1.0e30)));
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

// Four uniform numbers in [0, 1). `stream` is (pixel x, pixel y, sample); `dimension` says what they are for, so that
// no number is ever used twice, whatever path came before. 24 bits: the largest is 1 - 2^-24.
vec4 random4(uvec3 stream, uint dimension)
{
#if RANDOM_NUMBERS == 0
    return vec4(pcg4d(uvec4(stream, dimension)) >> 8u) * 5.96046448e-8;
#elif RANDOM_NUMBERS == 1
    return vec4(pcg4d(uvec4(stream, dimension)) >> 16u) * 1.52587891e-5;
#else
    float seed = float(hash32(stream.x + hash32(stream.y + hash32(stream.z))) >> 8u) * 5.96046448e-8;
    vec4 seeds = vec4(0.1, 0.2, 0.3, 0.4) + (seed + 0.4 * float(dimension));
    uvec4 bits = floatBitsToUint(seeds);
    return vec4(uvec4(hash32(bits.x), hash32(bits.y), hash32(bits.z), hash32(bits.w)) >> 8u) * 5.96046448e-8;
#endif
}

// Dimensions. A camera ray takes the first two; every bounce takes BOUNCE_DIMENSIONS more.
#define DIMENSION_LENS 0u    // pixel x, y; lens x, y
#define DIMENSION_TIME 1u    // shutter time
#define DIMENSION_BOUNCE 2u  // first bounce
#define BOUNCE_DIMENSIONS 2u // +0: direction x, y; lobe; roulette. +1: light x, y; which light; ball radius

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

// Waechter and Binder 2019 (Ray Tracing Gems, chapter 6): p moved off its surface towards the side that n points to,
// by a count of floats away from the origin, by 1/65536 of n near it.
vec3 offsetPoint(vec3 p, vec3 n)
{
#if OFFSET_SCHEME == 0
    ivec3 steps = ivec3(256.0 * n);
    ivec3 bits = floatBitsToInt(p);
    vec3 far = intBitsToFloat(ivec3(p.x < 0.0 ? bits.x - steps.x : bits.x + steps.x,
                                    p.y < 0.0 ? bits.y - steps.y : bits.y + steps.y,
                                    p.z < 0.0 ? bits.z - steps.z : bits.z + steps.z));
    vec3 near = p + 1.52587891e-5 * n;
    return vec3(abs(p.x) < 0.03125 ? near.x : far.x, abs(p.y) < 0.03125 ? near.y : far.y,
                abs(p.z) < 0.03125 ? near.z : far.z);
#else
    return p + 0.001 * n;
#endif
}

// The nearest t that counts as a hit.
#if OFFSET_SCHEME == 0
#define T_MIN 0.0
#else
#define T_MIN 0.001
#endif

// A ray that leaves p on the side of its surface that d points to.
Ray spawnRay(vec3 p, vec3 normal, vec3 d, float time)
{
    vec3 side = dot(d, normal) < 0.0 ? -normal : normal;
    return Ray(offsetPoint(p, side), d, p, time);
}

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

// fovy in degrees, clamped to [0.01, 179]; aperture is the lens diameter. An up vector along the view is replaced by
// an axis that isn't, an eye at its target looks along -z.
Camera createCamera(vec3 eye, vec3 at, vec3 worldUp, float fovy, float aspect, float aperture, float focusDist,
                    float time0, float time1)
{
    vec3 back = eye - at;
    vec3 n = directionOr(back, vec3(0.0, 0.0, 1.0));
    vec3 spare = abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, -1.0);
    vec3 u = directionOr(cross(worldUp, n), normalize(cross(spare, n)));
    vec3 v = cross(n, u);
    float planeDist = max(length(back), 1.0e-6);
    vec2 sc = sinCosTurn(clamp(fovy, 0.01, 179.0) * 0.00138888889);
    float height = 2.0 * planeDist * (sc.x / sc.y);
    return Camera(eye, u, v, n, vec2(aspect * height, height), planeDist, 0.5 * aperture, focusDist, time0, time1);
}

// Thin lens. pixel_sample is in [0, 1] x [0, 1] over the picture, xi is (lens, lens, shutter time).
Ray getRay(Camera cam, vec2 pixel_sample, vec3 xi)
{
    vec3 origin = cam.eye;
    vec2 target = (pixel_sample - 0.5) * cam.size * cam.focusDist;
    float time = cam.time0;
#ifdef HAS_LENS
    vec2 lens = cam.lensRadius * sampleDisk(xi.xy);
    origin = cam.eye + (lens.x * cam.u + lens.y * cam.v);
    target = target - lens;
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
#define METAL 1
#define DIELECTRIC 2

struct Material {
    int type;
    vec3 albedo;        // diffuse
    vec3 specColor;     // reflectance of metal
    vec3 emissive;      // radiance
    float roughness;    // [0, 1]
    float refIdx;
    vec3 refractColor;  // absorption per unit length, >= 0
};

Material createDiffuseMaterial(vec3 albedo)
{
    return Material(DIFFUSE, albedo, vec3(0.0), vec3(0.0), 1.0, 1.0, vec3(0.0));
}

Material createMetalMaterial(vec3 specColor, float roughness)
{
    return Material(METAL, vec3(0.0), specColor, vec3(0.0), clamp(roughness, 0.0, 1.0), 1.0, vec3(0.0));
}

Material createDielectricMaterial(vec3 refractColor, float refIdx, float roughness)
{
    return Material(DIELECTRIC, vec3(0.0), vec3(1.0), vec3(0.0), clamp(roughness, 0.0, 1.0), clamp(refIdx, 0.2, 5.0),
                    max(refractColor, vec3(0.0)));
}

struct HitRecord {
    vec3 pos;
    vec3 normal;  // outwards, of unit length; a negative radius turns it inwards
    float t;
    Material material;
};

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

// Fresnel's equations, unpolarised light, dielectrics. 1 beyond the critical angle.
float fresnelDielectric(float cosine, float etaI, float etaT)
{
    float c = clamp(cosine, 0.0, 1.0);
    float eta = etaT / etaI;
    float sin2 = ((1.0 - c) * (1.0 + c)) / (eta * eta);
    if (sin2 >= 1.0) {
        return 1.0;
    }
    float ct = sqrt(1.0 - sin2);
    float rs = (c - eta * ct) / (c + eta * ct);
    float rp = (eta * c - ct) / (eta * c + ct);
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

// Beer and Lambert: what is left after length d in a medium that absorbs sigma per unit length. 0 beyond 87.
vec3 transmittance(vec3 sigma, float d)
{
    vec3 y = (-1.44269504 * d) * sigma;
    return vec3(y.x < -126.0 ? 0.0 : portableExp2(y.x), y.y < -126.0 ? 0.0 : portableExp2(y.y),
                y.z < -126.0 ? 0.0 : portableExp2(y.z));
}

//-------------------------------------------------------------------------------
// Scattering
//-------------------------------------------------------------------------------

// Has the material a density of directions, so that light from a given direction can be weighed?
bool sampleableByLights(Material m)
{
    return m.type == DIFFUSE;
}

// BRDF times cosine. n is on the side of v; l and v point away from the surface.
vec3 evaluateBsdf(Material m, vec3 n, vec3 v, vec3 l)
{
    float NoL = dot(n, l);
    if (!(NoL > 0.0 && dot(n, v) > 0.0)) {
        return vec3(0.0);
    }
    return (NoL * INV_PI) * m.albedo;
}

// Lambert. The cosine and pi of the estimator cancel against the density of the directions.
vec3 diffuseAttenuation(vec3 albedo, float NoL)
{
#if SEED_ATTENUATION == 0
    return albedo;
#else
    return albedo * NoL;
#endif
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
        rScattered = spawnRay(rec.pos, rec.normal, d, rIn.time);
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
        rScattered = spawnRay(rec.pos, rec.normal, d, rIn.time);
        return true;
    }
#endif

    vec3 d = sampleCosineHemisphere(normal, xi.xy);
    float NoL = max(dot(normal, d), 0.0);
    attenuation = diffuseAttenuation(m.albedo, NoL);
    rScattered = spawnRay(rec.pos, rec.normal, d, rIn.time);
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
    vec3 size = abs(r.d);
    bool zLongest = size.z >= size.x && size.z >= size.y;
    bool yLongest = !zLongest && size.y >= size.x;
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
    vec3 normal = cross(tri.b - tri.a, tri.c - tri.a);
    if (dot(normal, normal) == 0.0) {
        return false;
    }
    rec.t = t;
    rec.pos = pointOnRay(r, t);
    rec.normal = normalize(normal);
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

// One plane, one pair of coordinates in [0, 1] along the edges: no diagonal, so no crack. The dual edges fold to
// constants when the quad is one.
bool hit_quad(Quad quad, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    vec3 n = cross(quad.edge1, quad.edge2);
    float n2 = dot(n, n);
    float slope = dot(r.d, n);
    if (slope == 0.0 || n2 == 0.0) {
        return false;
    }
    vec3 toOrigin = r.o - quad.corner;
    float t = -dot(toOrigin, n) / slope;
    vec3 dual1 = cross(quad.edge2, n) / n2;
    vec3 dual2 = cross(n, quad.edge1) / n2;
    vec3 p = toOrigin + t * r.d;
    float a = dot(p, dual1);
    float b = dot(p, dual2);
    bool within = a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0;
    if (!(within && t > tmin && t < tmax)) {
        return false;
    }
    rec.t = t;
    rec.pos = pointOnRay(r, t);
    rec.normal = n * inversesqrt(n2);
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

// The nearest root in (tmin, tmax) of |o + t d| = radius, or tmax when there is none. o is relative to the centre.
float sphereRoot(vec3 o, vec3 d, float radius, float tmin, float tmax)
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
        return tmax;
    }
    float s = sqrt(discriminant);
    float q = b >= 0.0 ? b + s : b - s;
    float t1 = c / q;
    float tNear = min(t1, q);
    float tFar = max(t1, q);
#else
    float discriminant = b * b - c;
    if (!(discriminant > 0.0)) {
        return tmax;
    }
    float s = sqrt(discriminant);
    float tNear = b - s;
    float tFar = b + s;
#endif
    float t = tNear > tmin ? tNear : tFar;
    return t > tmin && t < tmax ? t : tmax;
}

// The hit is moved back on to the sphere, where the offset of the next ray expects it.
bool hit_sphere(Sphere s, Ray r, float tmin, float tmax, inout HitRecord rec)
{
    vec3 o = r.o - s.center;
    float t = sphereRoot(o, r.d, s.radius, tmin, tmax);
    if (!(t < tmax)) {
        return false;
    }
    vec3 n = normalize(o + t * r.d);
    rec.t = t;
    rec.pos = s.center + abs(s.radius) * n;
    rec.normal = s.radius < 0.0 ? -n : n;
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
