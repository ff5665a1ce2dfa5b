// Five by three pixels a glyph, packed into integers.
const int glyphs[10] = int[10](31599, 9362, 31183, 31207, 23524, 29671, 29679, 30994, 31727, 31719);
float digit(ivec2 at, int value) {
  if (at.x < 0 || at.x > 2 || at.y < 0 || at.y > 4) return 0.0;
  int bit = 14 - ((4 - at.y) * 3 + at.x);
  return float((glyphs[value] >> bit) & 1);
}
void mainImage(out vec4 color, in vec2 p) {
  ivec2 at = ivec2(p) / 2 - ivec2(2, 10);
  int number = 3141592 + iFrame;
  float ink = 0.0;
  for (int i = 7; i >= 0; --i) {
    ink = max(ink, digit(at - ivec2(i * 4, 0), number % 10));
    number /= 10;
  }
  color = vec4(vec3(ink) * vec3(0.9, 1.0, 0.6), 1.0);
}
