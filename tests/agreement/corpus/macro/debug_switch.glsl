#define DEBUG 0
#if DEBUG
#define WATCH(x) color.rgb = vec3(x); return;
#else
#define WATCH(x)
#endif
#define IF(condition) if (condition) {
#define ELSE } else {
#define END }
void mainImage(out vec4 color, in vec2 p) {
  float f = fract(p.x / 24.0);
  color = vec4(0.0, 0.0, 0.0, 1.0);
  WATCH(f)
  IF(f < 0.5) color.r = f; ELSE color.g = 1.0 - f; END
  IF(mod(p.y, 16.0) < 8.0) color.b = 0.5; END
}
