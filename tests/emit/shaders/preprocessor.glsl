// Macros with and without parameters, continued lines, conditions, redefinition.
#define PI 3.14159265359
#define sq(x) ((x) * (x))
#define rot(a) mat2(1.0 - (a), -(a), \
                    (a), 1.0 - (a))
#define LOOP(n) for (int i = 0; i < n; i++)
#define DECLARE(type, name, value) type name = value
#ifdef GL_ES
#define BASE 1.0
#endif
#if 0
#error never
#elif defined(BASE) && __VERSION__ >= 300
#define ADD 2.0
#else
#define ADD 3.0
#endif
#undef BASE
#ifndef BASE
#define BASE 0.5
#endif
const float TAU = 2.0 * PI, THIRD = TAU / 3.0;
#define iTime (iTime + 0.25)
#define T iTime
float time_scale = 2.0; // not const
void mainImage( out vec4 O, vec2 U ) {
  DECLARE(float, acc, 0.0);
  LOOP(4) { acc += sq(float(i)) * ADD; }
  vec2 R = iResolution.xy, uv = (U + U - R) / R.y * rot(0.25);
  O = vec4(acc + BASE, uv, THIRD * time_scale + T);
}
