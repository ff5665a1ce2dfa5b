#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
layout(location = 0) out vec4 shadertoy_out_color;
#define SHADER_TOY 
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
#define texture2D texture
#define textureCube texture
#define texture2DProj textureProj
#define texture2DLodEXT textureLod
#define texture2DProjLodEXT textureProjLod
#define textureCubeLodEXT textureLod
#define texture2DGradEXT textureGrad
#define texture2DProjGradEXT textureProjGrad
#define textureCubeGradEXT textureGrad
#define iGlobalTime iTime
#define iGlobalFrame iFrame
#define varying in
#define gl_FragColor shadertoy_out_color
#define gl_FragDepthEXT gl_FragDepth
#define GLSL_FRAGCOLOR gl_FragColor
// Macros with and without parameters, continued lines, conditions, redefinition.
#define PI 3.14159265359
#define sq(x) ((x) * (x))
#define rot(a) mat2(1.0 - (a), -(a), \
                    (a), 1.0 - (a))
#define LOOP(n) for (int i = 0; i < n; i++)
#define DECLARE(type, name, value) type name = value
#ifdef GL_ES
#define BASE 1.0
#endif
#if 0
#error never
#elif defined(BASE) && __VERSION__ >= 300
#define ADD 2.0
#else
#define ADD 3.0
#endif
#undef BASE
#ifndef BASE
#define BASE 0.5
#endif
const float TAU = 2.0 * PI, THIRD = TAU / 3.0;
#define iTime (iTime + 0.25)
#define T iTime
float time_scale = 2.0; // not const
void mainImage( out vec4 O, vec2 U ) { O = vec4(0);
  DECLARE(float, acc, 0.0);
  LOOP(4) { acc += sq(float(i)) * ADD; }
  vec2 R = iResolution.xy, uv = (U + U - R) / R.y * rot(0.25);
  O = vec4(acc + BASE, uv, THIRD * time_scale + T);
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
