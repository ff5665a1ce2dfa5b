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

struct Thing { float weight; vec2 corners[2]; };
float table[1000];
vec2 pairs[3];
Thing things[2];

void take(out Thing thing, out float list[3], out mat2 turn)
{
if (iFrame > 100)
thing.weight = 1.0;
}

vec3 missing(float x)
{
if (x > 9.0)
return vec3(x);
}

Thing missing_thing(float x)
{
if (x > 9.0) {
Thing thing;
thing.weight = 3.0;
return thing;
}
}

float long_list(int n)
{
float list[300];
for (int i = 0; i < n; i++)
list[i] += 1.0;
float sum;
for (int i = 0; i < 300; i++)
sum += list[i];
return sum;
}

int calls = 0;
int next() { return calls++; }

vec3 partly(float x)
{
vec3 color;
if (x < 2.0)
color = vec3(1.0, 2.0, 3.0);
else if (x < 4.0)
color = vec3(4.0);
else
color.x = 0.5;
return color;
}

float rounds(float x)
{
float sum = 0.0;
for (int k; k < 3; k++) {
float a = 1.0, z;
for (; z < 1.0; z += 0.25)
a += fract(x * z);
sum += a;
}
return sum;
}

void mainImage(out vec4 c, in vec2 p)
{
table[int(p.x)] += 1.0;
float sum;
for (int i = 0; i < 1000; i++)
sum += table[i];
for (float i, kept; i < 3.0; i++) {
float fresh;
kept += i;
fresh += kept;
sum += kept + fresh;
}

Thing thing;
thing.weight = 5.0;
thing.corners[1] = p;
float list[3] = float[3](1.0, 2.0, 3.0);
mat2 turn = mat2(3.0);
take(thing, list, turn);
float outs = thing.weight + thing.corners[1].x + list[1] + turn[1][1];

int far = int(p.x) * 9 - 40;
uint unsigned_far = uint(far);
float five[5] = float[](1.0, 2.0, 3.0, 4.0, 5.0);
mat3 m = mat3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);
five[far] += 10.0;
five[next()] += 100.0;
m[far][unsigned_far] += 1000.0;
float indexed = five[0] + five[4] * 2.0 + m[0][0] + m[2][2] * 3.0 + vec3(1, 2, 3)[far] + five[unsigned_far] +
float(calls) + pairs[far].x + things[far].weight;

vec3 nowhere = missing(p.x) + missing_thing(p.y).weight;
c = vec4(sum + long_list(3) + long_list(4), outs, indexed, nowhere.y + dot(partly(p.x), vec3(1.0, 10.0, 100.0)) + rounds(p.y));
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
