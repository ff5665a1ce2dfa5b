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

mat3 rotation(float a) { float c = 0.5 + a, s = 0.25; return mat3(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0); }
void mainImage(out vec4 color, in vec2 p) {
mat2 m = mat2(1.0, 2.0, p.x, p.y);
m *= 2.0; m += 1.0; m[1] -= vec2(0.5); m[0][1] = 4.0; m -= mat2(1.0);
vec2 v = p; v *= m; v = m * v;
mat3 r = rotation(p.x / 8.0);
mat3 rr = r * r; rr *= r;
vec3 w = vec3(p, 1.0); w *= r; w.xy *= m;
mat2x3 n = mat2x3(p.x, 1.0, 2.0, p.y, 3.0, 4.0);
mat3x2 nt = transpose(n);
vec3 nv = n * p; vec2 vn = nv * n; mat2 nn = nt * n;
mat4 big = mat4(mat2(m)); big[3] = vec4(w, 1.0); mat3 small = mat3(big); mat2 from = mat2(vec2(1.0, 2.0), p);
mat2 mixed = mat2(p.x, vec2(1.0, 2.0), 3.0), product = matrixCompMult(m, from), outer = outerProduct(p, vec2(1.0, 2.0));
mat2 quotient = m / 2.0; mat2 same = m; same++;
int i = int(p.x) % 3;
float det = determinant(mat2(2.0, 1.0, p.x, 3.0));
mat2 inv = inverse(mat2(2.0, 0.0, 0.0, 4.0));
color = vec4(v, w.x + w.y, rr[i].x);
if (p.y > 2.0) color = vec4(nv.x, vn.y, nn[1][0], small[i][2]);
if (p.y > 4.0) color = vec4(mixed[1][0], product[0][1], outer[1].y, quotient[0].x + (m == same ? 1.0 : 0.0));
if (p.y > 6.0) color = vec4(det, inv[1][1], -m[0].x, (-m + same)[0][0]);
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
