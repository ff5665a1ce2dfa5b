#define LAYER 0.1
float first(float x) { return step(LAYER, x); }
#undef LAYER
#define LAYER 0.4
float second(float x) { return step(LAYER, x); }
#undef LAYER
#define LAYER first(x) * 0.25 + second(x) * 0.5
float both(float x) { return LAYER; }
void mainImage(out vec4 color, in vec2 p) { color = vec4(both(p.x / iResolution.x), both(p.y / iResolution.y), 0.5, 1.0); }
