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
#define saturate(a) clamp(a, 0.0, 1.0)
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
// Names of GLSL ES 1.00 and of older players, which the VS Code extension takes.

varying vec2 unused;
float level() { return texture2D(iChannel0, gl_FragCoord.xy / iResolution.xy).x + iGlobalTime; }
void main() { gl_FragColor = vec4(saturate(level())); }
