// switch: falling through, default in the middle, variables across labels, return and nested loops inside.
float choose(int k) {
  float r = 0.0;
  switch (k) {
    case 0: return 1.0;
    case 1: r += 2.0;
    case 2: { float t = 3.0; r += t; break; }
    default: r = -1.0; break;
    case 4: for (int i = 0; i < 9; i++) { if (i == 3) break; r += 4.0; } r += 0.5;
    case 5: { r *= 2.0; }
  }
  switch (k % 2) { case 0: float z = 5.0; r += z; break; case 1: z = 7.0; r -= z; }
  return r;
}
float early(float x) { if (x < 2.0) return x; else if (x < 4.0) { x *= 2.0; } else return -x; for (int i = 0; i < 3; i++) if (x > 5.0) return 9.0; return x; }
void nothing(int k) { switch (k) { case 1: { return; } case 2: {} default: { ; } } }
int pick(uint u) { nothing(int(u)); switch (u) { case 3u: return 30; default: return 40; } }
void mainImage(out vec4 color, in vec2 p) {
  color = vec4(choose(int(p.x)), early(p.x), float(pick(uint(p.y))), early(p.y));
}
