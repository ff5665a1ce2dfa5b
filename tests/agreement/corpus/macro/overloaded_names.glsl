#define vec vec3
#define v(x) vec(x)
#define f(x, y) (x##y_not_pasted)
#undef f
#define f(x) float f_##x
#undef f
#define f(x) (x) * .5 + .5
void mainImage(out vec4 color, in vec2 p) { vec c = v(0.25); c.x = f(c.y) * step(40.0, p.x); color = vec4(c, 1.0); }
