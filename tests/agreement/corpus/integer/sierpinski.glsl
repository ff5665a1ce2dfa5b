void mainImage(out vec4 color, in vec2 p) {
  int x = int(p.x), y = int(p.y), n = 0;
  for (int m = x & y; m != 0; m &= m - 1) ++n;
  color = vec4(n == 0, n == 1, float(n) / 6.0, 1.0);
}
