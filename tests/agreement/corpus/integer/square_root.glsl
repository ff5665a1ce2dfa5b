int isqrt(int n) {
  int x = 0, bit = 1 << 14;
  for (; bit > n; bit >>= 2) continue;
  for (; bit != 0; bit >>= 2) {
    if (n >= x + bit) { n -= x + bit; x = (x >> 1) + bit; } else x >>= 1;
  }
  return x;
}
void mainImage(out vec4 color, in vec2 p) {
  ivec2 d = ivec2(p) - ivec2(64, 36);
  int r = isqrt(d.x * d.x + d.y * d.y);
  color = vec4(r % 8 < 4, r * r == d.x * d.x + d.y * d.y, float(r) / 80.0, 1.0);
}
