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

  
  
float f(float x); float f(vec2 v); float f(int i);
 float g(const in  float x, int unused) { return x + 1.0; }
float f(uint u) { return float(u) + 0.125; }
float f(int i) { return float(i) + 0.25; }
float f(float x) { return x + 0.5; }
float f(vec2 v) { return f(v.x) + f(v.y); }
float f(vec2 v, float w) { return f(v) * w; }
float f(mat2 m) { return m[0][0]; }
float f(float v[2]) { return v[0] - v[1]; }
bool f(bool b) { return !b; }
void nothing() {}
vec4 zero() { nothing(); return vec4(0); }
void mainImage(out  vec4 color, in  vec2 p) {
color = zero() + vec4(f(p.x) + f(int(p.x)), f(p, 2.0), f(uint(p.y)) + f(mat2(p.x)), g(p.y, 3) + f(float[2](p.x, p.y)) + (f(p.x > 3.0) ? 1.0 : 0.0));
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
