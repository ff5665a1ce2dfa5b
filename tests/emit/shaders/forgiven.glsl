// What browsers take and other compilers of the same language refuse.
precision mediump float;
#if 0
don't read "this
#endif
#define SIGNED(sign) sign 1.0
struct Segment { float length; vec2 way; };
float step = 0.25, packed = 2.0;
const mat3 turned = transpose(mat3(1, 2, 3, 4, 5, 6, 7, 8, 9));
vec2 mix(vec2 a, vec2 b, vec3 c) { return a * c.xy + b * c.z; }
lowp vec3 fma(mediump vec3 a, vec3 b, highp vec3) { return a * b; }
float choose(int k)
{
    switch (k) {
        case 0: return 1.0;
        case 1: ;
    }
    return step;
}
void mainImage(out lowp vec4 c, mediump vec2 p)
{
    Segment s = Segment(2.0, p);
    s.length *= SIGNED() + SIGNED(-) + step;
    c = vec4(mix(p, s.way, vec3(1, 2, 3)), mix(1.0, 2.0, 0.5) * packed, choose(int(p.x)) + s.length);
    c.xyz += fma(turned[1], vec3(p, 1), vec3(0));
}
