// Path tracer, Image: exposure, tone, sRGB. The entry file.
//
// On shadertoy.com, each file pasted unmodified (NAME is weekend, fuzzy_refraction, metal_roughness, plastic, cornell):
//   Common    scenes/NAME.glsl, then common.glsl
//   Buffer A  scenes/NAME.glsl, then P3D_RT.glsl   iChannel0 Buffer A, 1 and 2 cubemaps (all but weekend), 3 Buffer B
//   Buffer B  camera.glsl                          iChannel0 Buffer B; optional, for the mouse
//   Image     image.glsl                           iChannel0 Buffer A
// In VS Code open this file and run "Shader Toy: Show GLSL Preview"; scenes/select.glsl says which scene.

#ifdef SHADER_TOY
#iChannel0 "P3D_RT.glsl"
#iChannel0::MinFilter "Nearest"
#iChannel0::MagFilter "Nearest"
#iChannel0::WrapMode "Clamp"
#include "scenes/select.glsl"
#include "common.glsl"
#endif

// Stops of exposure on top of the scene's own.
#ifndef EXPOSURE
#define EXPOSURE 0.0
#endif

// Tone curve. 0: none, highlights clip. 1: Reinhard on luminance, soft and flat. 2: the usual rational fit to ACES,
// contrasty, highlights turn white. 3: Khronos PBR Neutral, colours stay as lit up to 0.8 and only highlights bend.
#ifndef TONE_CURVE
#define TONE_CURVE 3
#endif

// Encoding for the screen. 0: sRGB, exact. 1: gamma 2.2, as in the report's assignment. Both cost one power a channel.
#ifndef DISPLAY_ENCODING
#define DISPLAY_ENCODING 0
#endif

#if TONE_CURVE < 0 || TONE_CURVE > 3
#error TONE_CURVE is 0 (none), 1 (Reinhard), 2 (ACES) or 3 (Neutral)
#endif
#if DISPLAY_ENCODING < 0 || DISPLAY_ENCODING > 1
#error DISPLAY_ENCODING is 0 (sRGB) or 1 (gamma 2.2)
#endif

vec3 toneMap(vec3 c)
{
#if TONE_CURVE == 0
    return c;
#elif TONE_CURVE == 1
    return c / (1.0 + dot(c, vec3(0.2126, 0.7152, 0.0722)));
#elif TONE_CURVE == 2
    // Narkowicz 2016, "ACES Filmic Tone Mapping Curve", its factor 0.6 of exposure multiplied out.
    return (c * (0.9036 * c + 0.018)) / (c * (0.8748 * c + 0.354) + 0.14);
#else
    // Khronos 2024, "PBR Neutral Tone Mapper": 0.04 of Fresnel reflection is taken off, values from 0.76 on approach 1,
    // and what would have been brighter loses saturation.
    float least = min(c.r, min(c.g, c.b));
    vec3 x = least < 0.08 ? (c - least) + 6.25 * (least * least) : c - 0.04;
    float peak = max3(x);
    if (peak < 0.76) {
        return x;
    }
    float bent = 1.0 - 0.0576 / (peak - 0.52);
    float white = 1.0 - 1.0 / (0.15 * (peak - bent) + 1.0);
    return lerp(x * (bent / peak), vec3(bent), white);
#endif
}

vec3 encode(vec3 c)
{
#if DISPLAY_ENCODING == 0
    return toGamma(c);
#else
    vec3 x = clamp(c, 0.0, 1.0);
    return vec3(portablePow(x.r, 0.454545455), portablePow(x.g, 0.454545455), portablePow(x.b, 0.454545455));
#endif
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec3 mean = texelFetch(iChannel0, ivec2(fragCoord), 0).rgb;
#ifdef ACCUMULATION
#if ACCUMULATION == 1
    fragColor = vec4(mean, 1.0);
    return;
#endif
#endif
    float exposure = portableExp2(OPAQUE(EXPOSURE + SCENE_EXPOSURE));
    fragColor = vec4(encode(toneMap(exposure * mean)), 1.0);
}
