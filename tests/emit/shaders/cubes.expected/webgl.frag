#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;

layout(location = 0) out vec4 shadertoy_out_color;
uniform vec3 iResolution;
uniform float iTime;
uniform float iTimeDelta;
uniform int iFrame;
uniform vec4 iDate;
uniform vec4 iMouse;
uniform float iSampleRate;
uniform vec4 iMouseButton;
uniform mat4 iViewMatrix;
uniform vec3 iChannelResolution[10];
uniform samplerCube iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
uniform sampler2D iChannel4;
uniform sampler2D iChannel5;
uniform sampler2D iChannel6;
uniform sampler2D iChannel7;
uniform sampler2D iChannel8;
uniform sampler2D iChannel9;
uniform sampler2D iKeyboard;






uint hash(uint x) {
x ^= x >> 16;
x *= 0x7feb352du;
x ^= x >> 15;
x *= 0x846ca68bu;
return x ^ (x >> 16);
}
float signed_fraction(uint x) { return float(int(hash(x)) >> 8) * (1.0 / 8388608.0); }


vec3 direction(uint n) {
uint h = hash(n);
vec3 at = vec3(signed_fraction(3u * n), signed_fraction(3u * n + 1u), signed_fraction(3u * n + 2u));
vec3 corner = vec3(ivec3((h >> 4) & 2u, (h >> 5) & 2u, (h >> 6) & 2u) - 1);
if ((n & 3u) < 2u) return corner + at * 0.015;
if ((n & 3u) == 2u) return vec3(corner.xy + at.xy * 0.015, at.z);
return at;
}
uvec4 mixed(uvec4 sum, vec4 color) { return (sum ^ floatBitsToUint(color)) * 0x9e3779b1u; }

void mainImage(out vec4 color, in vec2 p) {
uint pixel = uint(p.x) + 64u * uint(p.y);
uvec4 sum = uvec4(0u);
vec3 d = vec3(1.0);
for (uint i = 0u; i < 48u; i++) {
uint n = 48u * pixel + i;
d = direction(n);
sum = mixed(sum, textureLod(iChannel0, d, 0.0));
sum = mixed(sum, textureLod(iChannel0, d, 4.0 + 5.0 * d.y * d.z));
if (hash(n) % 29u == 0u) break;
}
sum = mixed(sum, texture(iChannel0, d));
sum = mixed(sum, textureGrad(iChannel0, d, dFdx(d.zxy) * 0.1, dFdy(d)));
color = vec4(sum >> 8) * (1.0 / 16777216.0);
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
