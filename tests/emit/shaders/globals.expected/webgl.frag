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

float a = 1.0; vec3 b = vec3(1.0, 2.0, 3.0) * 2.0; int count = 3;
float c, d = 4.0;
const vec2 k = vec2(0.5, 0.25), kk = k * 2.0 + k.yx;
float list[3] = float[3](1.0, 2.0, 3.0);
mat2 m = mat2(1.0, 0.0, 0.0, 1.0);
struct S { float x; vec2 y; } s = S(1.0, vec2(2.0));
vec4 unused;
float step_() { a += 1.0; count--; list[1] *= 2.0; s.y.x += a; return a; }
void mainImage(out vec4 color, in vec2 p) {
b.xy = p; c = step_() + step_() * 8.0; m[1] *= p;
for (int i = 0; i < 2; i++) c += list[i] + float(count);
color = vec4(a + c, b.x + d, kk + s.y * m);
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
