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

float choose(int k) {
float r = 0.0;
switch (k) {
case 0: return 1.0;
case 1: r += 2.0;
case 2: { float t = 3.0; r += t; break; }
default: r = -1.0; break;
case 4: for (int i = 0; i < 9; i++) { if (i == 3) break; r += 4.0; } r += 0.5;
case 5: { r *= 2.0; }
}
switch (k % 2) { case 0: float z = 5.0; r += z; break; case 1: z = 7.0; r -= z; }
return r;
}
float early(float x) { if (x < 2.0) return x; else if (x < 4.0) { x *= 2.0; } else return -x; for (int i = 0; i < 3; i++) if (x > 5.0) return 9.0; return x; }
void nothing(int k) { switch (k) { case 1: { return; } case 2: {} default: break; { ; } } }
int pick(uint u) { nothing(int(u)); switch (u) { case 3u: return 30; default: return 40; } }
void mainImage(out vec4 color, in vec2 p) {
color = vec4(choose(int(p.x)), early(p.x), float(pick(uint(p.y))), early(p.y));
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
