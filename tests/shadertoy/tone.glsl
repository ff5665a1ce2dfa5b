// The tone curve TONE_CURVE and the screen's encoding. x: light. y: toned, encoded.
#include "../../shadertoy/scenes/fuzzy_refraction.glsl"
#include "../../shadertoy/common.glsl"
#undef SHADER_TOY
#define mainImage showImage
#include "../../shadertoy/image.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    y[0].xyz = toneMap(x[0].xyz);
    y[1].xyz = encode(x[0].xyz);
}

#include "probe.glsl"
