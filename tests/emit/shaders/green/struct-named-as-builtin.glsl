// A structure may bear the name of a built-in function.
struct length { float x; };
void mainImage(out vec4 o, vec2 p) { length l = length(3. + iTime); bool ok = l.x == 3.; o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.); }
