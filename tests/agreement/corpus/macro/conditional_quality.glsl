#define QUALITY 2
#if QUALITY == 0
#define STEPS 4
#elif QUALITY == 1
#define STEPS 8
#elif QUALITY >= 2 && !defined(MOBILE)
#define STEPS 16
#else
#error no such quality
#endif
#ifdef GL_ES
#define ACCENT vec3(1.0, 0.6, 0.2)
#endif
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < STEPS; ++i) sum += ACCENT * step(float(i) / float(STEPS), uv.x * uv.y);
  color = vec4(sum / float(STEPS), 1.0);
}
