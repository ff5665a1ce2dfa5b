#define LOOP(n) for (int i = 0; i < n; ++i)
#define UNLESS(c) if (!(c))
#define RETURN_IF(c, v) if (c) { color = v; return; }
#define between(x, a, b) ((x) >= (a) && (x) < (b))
void mainImage(out vec4 color, in vec2 p) {
  RETURN_IF(between(p.x, 10., 20.), vec4(1, 0, 0, 1))
  RETURN_IF(between(p.y, 30., 33.), vec4(0, 1, 0, 1))
  float s = 0.;
  LOOP(10) UNLESS(i == 3) s += between(p.x, float(i) * 12., float(i) * 12. + 6.) ? .1 * float(i) : 0.;
  color = vec4(s, s * .5, 1. - s, 1);
}
