// An entry point that a macro makes.
#define mainImage(o, u) mainImage(out vec4 o, vec2 u)
void mainImage(o, u) { o = vec4(u, 0, 1); }
