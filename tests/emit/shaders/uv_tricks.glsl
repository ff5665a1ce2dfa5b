// Golfed code: chained assignments, loops without bodies, everything in one statement.
#define R iResolution
#define S(a) smoothstep(0.1, 0.9, a)
mat2 r(float a) { return mat2(0.8, -0.6, 0.6, 0.8) * a; }
void mainImage(out vec4 O, vec2 U)
{
    vec2 u = (U+U-R.xy)/R.y, v = u*0.;
    O *= 0.; float i = 0., d = 1., z = 0.; vec3 q, p = vec3(0);
    for (O = vec4(0); i++ < 9.; O += .1 / max(d, .01)) p = z * normalize(vec3(u, 1)), p.z -= 2., z += d = abs(length(p) - 1.) * .5 + .01, q = p;
    for (int k = 0; k < 3; k++, u *= r(1.1), v += u);
    int n = 7; n = (n & 1) == 1 ? n * 3 + 1 : n / 2, n -= 2;
    O.rg += v *= 0.25; (O.b) = float(n) + S(u.x > 0. ? u.x : -u.x);
    O = abs(O), O.a = 1. - (U.x < 5. ? .5 : .25), O = O.x > 3. ? O.yxzw : O;
}
