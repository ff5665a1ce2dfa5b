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

  




struct Segment { float shadertwin_length; vec2 way; };
float shadertwin_step = 0.25, shadertwin_packed = 2.0;
const mat3 turned = transpose(mat3(1, 2, 3, 4, 5, 6, 7, 8, 9));
float shadertwin_mix(float a, float b, float c) { return mix(a, b, c); } float shadertwin_mix(float a, float b, bool c) { return mix(a, b, c); } vec2 shadertwin_mix(vec2 a, vec2 b, vec2 c) { return mix(a, b, c); } vec2 shadertwin_mix(vec2 a, vec2 b, float c) { return mix(a, b, c); } vec2 shadertwin_mix(vec2 a, vec2 b, bvec2 c) { return mix(a, b, c); } vec3 shadertwin_mix(vec3 a, vec3 b, vec3 c) { return mix(a, b, c); } vec3 shadertwin_mix(vec3 a, vec3 b, float c) { return mix(a, b, c); } vec3 shadertwin_mix(vec3 a, vec3 b, bvec3 c) { return mix(a, b, c); } vec4 shadertwin_mix(vec4 a, vec4 b, vec4 c) { return mix(a, b, c); } vec4 shadertwin_mix(vec4 a, vec4 b, float c) { return mix(a, b, c); } vec4 shadertwin_mix(vec4 a, vec4 b, bvec4 c) { return mix(a, b, c); } vec2 shadertwin_mix(vec2 a, vec2 b, vec3 c) { return a * c.xy + b * c.z; }
 vec3 shadertwin_fma( vec3 a, vec3 b,  vec3 shadertwin_unnamed_0) { return a * b; }
float choose(int k)
{
switch (k) {
case 0: return 1.0;
case 1: break; ;
}
return shadertwin_step;
}
void mainImage(out  vec4 c,  vec2 p)
{
Segment s = Segment(2.0, p);
s.shadertwin_length *= 1.0 + - 1.0 + shadertwin_step;
c = vec4(shadertwin_mix(p, s.way, vec3(1, 2, 3)), shadertwin_mix(1.0, 2.0, 0.5) * shadertwin_packed, choose(int(p.x)) + s.shadertwin_length);
c.xyz += shadertwin_fma(turned[1], vec3(p, 1), vec3(0));
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
