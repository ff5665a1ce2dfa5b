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
uniform float iFrameRate;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
int shadertwin_failed = -1; void st_assert(bool condition, int kind) { if (!condition) shadertwin_failed = kind; } void st_assert(bool condition) { st_assert(condition, 0); }
void mainImage(out vec4, in vec2);
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); if (shadertwin_failed >= 0) shadertoy_color.rgb = vec3(shadertwin_failed == 0 || shadertwin_failed == 3, shadertwin_failed == 1 || shadertwin_failed == 3, shadertwin_failed == 2); shadertoy_out_color = vec4(shadertoy_color.rgb, 1.0); }


float wave(float t, float hertz) { return sin(6.2831853 * hertz * t); }

void mainImage(out vec4 c, in vec2 p) {
float levels[3];
levels[int(p.x) % 3] = texture(iChannel0, p / iResolution.xy).x;
st_assert(levels[0] >= 0.0);
c = vec4(levels[0], levels[1], iChannelResolution[0].xy);
}
void mainVR(out vec4 c, in vec2 p, in vec3 origin, in vec3 direction) { c = vec4(direction, 1.0); }
