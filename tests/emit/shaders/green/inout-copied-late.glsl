// What comes in through an inout argument is read when the call begins, behind the effects of other arguments.
int n = 0; int next() { return ++n; }
void add(int d, inout int v) { v += d; }
float sum(float x, inout float y) { y += x; return y; }
void mainImage(out vec4 o, vec2 p) { add(next(), n); float y = 1. + iTime; float x = sum(sum(2., y), y); bool ok = n == 2 && x == 6. && y == 6.; o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.); }
