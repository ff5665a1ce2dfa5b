// green
#define A 3
#if A == 1
#define R 1
#elif A == 2
#define R 2
#elif (A > 2) && (A < 4)
#if defined(B) || A % 2 == 0
#define R 30
#else
#define R 3
#endif
#elif 1
#define R 99
#endif
#if 0
#elif 0
#else
#define S R
#endif
void mainImage(out vec4 color, in vec2 p) { color = S == 3 ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1); }
