#ifndef SCALE
#define SCALE 8.
#endif
#if defined(SCALE) && !defined SHAPE
#define SHAPE(p) max(abs(p.x), abs(p.y))
#endif
#ifdef UNUSED
this is no code at all: "quoted 'things' #
#else
#ifdef SHAPE
#define INK vec3(.9, .2, .2)
#endif
#endif
void mainImage(out vec4 color, in vec2 p) { vec2 q = fract(p / SCALE) - .5; color = vec4(INK * step(SHAPE(q), .3), 1.); }
