// 16.16 fixed point.
int mul(int a, int b) { return (a >> 8) * (b >> 8); }
void mainImage(out vec4 color, in vec2 p) {
  int cx = int(p.x) * 1400 - 135000, cy = int(p.y) * 1400 - 50000;
  int x = 0, y = 0, n = 0;
  for (; n < 32; ++n) {
    int xx = mul(x, x), yy = mul(y, y);
    if (xx + yy > 262144) break;
    y = 2 * mul(x, y) + cy;
    x = xx - yy + cx;
  }
  color = vec4(float(n & 7) / 7.0, float(n & 3) / 3.0, float(n) / 32.0, 1.0);
}
