#define TICKS ivec2(0)
#define SEED ivec2(1, 0)
#define RES iResolution.xy
uint hash(uint x) { x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; return x ^ (x >> 16); }
vec2 cell_of(vec2 p) { return floor(p / 8.0); }
