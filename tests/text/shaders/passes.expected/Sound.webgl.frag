#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;

layout(location = 0) out vec4 shadertoy_out_color;
uniform float iTimeOffset;
uniform int iSampleOffset;
uniform vec4 iDate;
uniform float iSampleRate;
uniform vec3 iChannelResolution[4];
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
vec2 mainSound(in int, in float);
void main() { int shadertwin_sample = int(gl_FragCoord.x) + 512 * int(gl_FragCoord.y); float shadertwin_time = iTimeOffset + float(shadertwin_sample) / iSampleRate; shadertoy_out_color = vec4(mainSound(iSampleOffset + shadertwin_sample, shadertwin_time), 0.0, 1.0); }


float wave(float t, float hertz) { return sin(6.2831853 * hertz * t); }
vec2 mainSound(int samp, float time) { return vec2(wave(time, 440.0), wave(time, 441.0)); }
