// The size of an array is known, but the call that gives the array has its effects all the same.
int n = 0; float[3] f() { n++; return float[3](1., 2., 3.); }
void mainImage(out vec4 o, vec2 p) { int l = f().length(); bool ok = l == 3 && n == 1; o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.); }
