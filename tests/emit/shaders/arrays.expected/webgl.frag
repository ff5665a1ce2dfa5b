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
uniform sampler2D iChannel0;
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

const vec3 palette[4] = vec3[](vec3(0.1, 0.2, 0.3), vec3(1.0), vec3(0.5, 0.25, 0.125), vec3(-1.0, 2.0, 7.0));
const int steps[5] = int[5](3, 1, 4, 1, 5);
const mat2 turns[2] = mat2[](mat2(0.0, 1.0, -1.0, 0.0), mat2(0.5));
float table[6];
float total(float v[6]) { v[0] = 100.0; float s = 0.0; for (int i = 0; i < v.length(); i++) s += v[i]; return s; }
float[2] both(float a) { return float[](a, a * a); }
void mainImage(out vec4 color, in vec2 p) {
int k = int(p.x) % 8;
for (int i = 0; i < 6; ++i) table[i] = float(i * i);
const float weights[] = float[](0.25, 0.5, 0.125);
float w = 0.0;
for (int i = 0; i < weights.length(); i++) w += weights[i] * float(i + 1);
float local[3];
local[k % 3] = 2.0;
float copy[3] = local;
copy[0] += 1.0;
vec2 turned = turns[k & 1] * vec2(1.0, 2.0);
color = vec4(palette[clamp(k, 0, 3)][k % 3], float(steps[k % 5]) + total(table) * 16.0, w + both(p.y)[1], turned.x);
if (p.y > 3.0) color = vec4(local[0] + local[1], copy[0], copy == local ? 1.0 : 0.0, table[5]);
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
