// pcg4d, and hash32 of the key's first word. Words travel as two halves of 16 bits, which floats hold.
// x: low halves of the key, high halves. y: the same of pcg4d; low and high half of hash32.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    uvec4 key = uvec4(x[0]) | (uvec4(x[1]) << 16u);
    uvec4 hash = pcg4d(key);
    uint h = hash32(key.x);
    y[0] = vec4(hash & 0xffffu);
    y[1] = vec4(hash >> 16u);
    y[2] = vec4(float(h & 0xffffu), float(h >> 16u), 0.0, 0.0);
}

#include "probe.glsl"
