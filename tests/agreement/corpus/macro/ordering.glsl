// A macro is looked up where it is used, not where it was defined.
#define COLOR mix_of(RED, GREEN)
#define RED .8
#define GREEN .3
#define mix_of(a, b) vec3(a, b, 1. - (a))
vec3 first() { return COLOR; }
#undef GREEN
#define GREEN .7
vec3 second() { return COLOR; }
void mainImage(out vec4 color, in vec2 p) { color = vec4(p.x < p.y * 1.7 ? first() : second(), 1.); }
