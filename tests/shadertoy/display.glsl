// Accumulation and sRGB. Functions: 0 sRGB there and back, x: code / 255, linear. y: decoded, encoded, there and back.
// 1 the mean of x.y random samples between 0 and x.z plus x.x, added one by one. y: mean, number.
// 2 one sample added to a mean, x: mean, sample.
// 3 x[1].y samples added to a mean, x: mean, (number of the first, how many, least, range). The numbers of a golden
// sequence, exact in float.
#include "../../shadertoy/scenes/fuzzy_refraction.glsl"
#include "../../shadertoy/common.glsl"
#include "../../shadertoy/scenes/fuzzy_refraction.glsl"
#undef SHADER_TOY
#define mainImage traceImage
#include "../../shadertoy/P3D_RT.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    if (iFrame == 0) {
        y[0] = vec4(srgbDecode(x[0].x), srgbEncode(x[0].y), srgbEncode(srgbDecode(x[0].x)), toGamma(x[0].yyy).x);
    } else if (iFrame == 1) {
        vec4 mean = vec4(0.0);
        for (int i = 0; i < int(x[0].y); i++) {
            vec4 xi = random4(uvec3(index, 0u, uint(i)), 0u);
            mean = accumulate(mean, x[0].x + x[0].z * xi.xyz);
        }
        y[0] = mean;
    } else if (iFrame == 2) {
        y[0] = accumulate(x[0], x[1].xyz);
    } else {
        vec4 mean = x[0];
        for (int i = 0; i < int(x[1].y); i++) {
            uint golden = (uint(x[1].x) + uint(i)) * 2654435769u;
            mean = accumulate(mean, vec3(x[1].z + x[1].w * (float(golden >> 8u) * 5.96046448e-8)));
        }
        y[0] = mean;
    }
}

#include "probe.glsl"
