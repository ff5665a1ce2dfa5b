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


struct Item { vec2 at; int tag; bool on; };
struct Bag { Item items[3]; mat2 turn; };
int steps = 0;
const Item first[2] = Item[2](Item(vec2(1, 2), 3, true), Item(vec2(4, 5), 6, false));
const bool odd[3] = bool[3](false, true, true);
const float grid[6] = float[6](0.5, 1.5, 2.5, 3.5, 4.5, 5.5);
int early(int n) {
for (int i = 0; i < 20; i++) {
if (i * i > n) return i;
for (int j = 0; ; j++) {
if (j > i) break;
if ((j + n) % 5 == 4) return 100 + j;
steps++;
}
}
return -1;
}
bool count(inout int n) { n++; steps += 2; return (n & 1) == 0; }
int route(int n) {
int sum = 0;
for (int i = 0; i < 7; i++) {
switch ((n + i) % 6) {
case 0: sum += 1;
case 1: sum += 10; break;
case 2: if (n > 9) continue; sum += 100; break;
case 5: if (n == 3) return sum + 100000;
default: sum += 1000;
}
sum += i;
if (sum > 4000 + n) break;
}
return sum;
}
float walk(vec2 p, out int rounds) {
float x = p.x;
rounds = 0;
do {
rounds++;
if (mod(float(rounds) + p.y, 3.0) < 1.0) continue;
x *= 0.75;
if (x < 0.4) return -x;
} while (rounds < 9 && (x > 1.0 || count(steps)));
while (true) { if (x > 8.0 + p.y) break; x = x * 1.5 + 1.0; if (rounds > 6) { x = -3.0; break; } }
return x;
}
void put(inout Bag bag, int i, int j) {
bag.items[i].at[j] += 2.0;
bag.items[i].tag = i * 3 + j;
bag.items[(i + 1) % 3].on = odd[i % 3];
bag.turn[j][i & 1] -= 0.25;
if (i == 1) { bag.items[j].at.yx = vec2(float(j), grid[i + 4 * j]); return; }
bag.turn[i & 1].xy *= 2.0;
}
void mainImage(out vec4 color, in vec2 p) {
ivec2 q = ivec2(p);
int n = q.x * 3 + q.y;
int a = early(n), b = route(n % 13), r = n % 4, c = 0;
float w = walk(p * 0.5, r);
Bag bag = Bag(Item[3](first[0], first[1], first[n & 1]), mat2(1, 0, 0, 1));
put(bag, n % 3, (n / 2) % 2);
if (n % 7 > 2 && count(c) || n % 5 == 1 && !count(c)) c += 10; else if (n % 2 == 0) c -= 5;
c += n % 3 == 0 ? (count(c), c * 2) : n % 3 == 1 ? int(grid[n % 9 - 1]) : -c;
vec4 v = vec4(p, 1, 2);
v[n % 6 - 1] = 7.0;
int more[2];
more[0] = 5; more[1] = n;
more[n & 1]++;
int i = 0;
for (; i < 9; i++) { if (i == n % 11) break; if (i % 2 == 0) continue; more[i & 1] += i; }
if (n % 8 < 6) { if (first[n % 3] == first[1]) c += 1000; if (bag.items[0] != first[0]) c += 2000; }
Item some = bag.items[(n + 1) % 3];
color = vec4(a + b, w + float(r), dot(some.at, bag.turn * v.xy) + float(some.tag) + v.z * v.w,
c + i * 10 + more[0] * 100 + more[1] + steps + (some.on ? 5000 : 0));
}
void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); shadertoy_out_color = shadertoy_color; }
