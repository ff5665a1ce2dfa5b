// green
float choose(int n) {
  if (n < 0) return -1.0;
  for (int i = 0; i < 5; ++i) {
    if (i == n) { if (n == 3) return 33.0; break; }
    for (int k = 0; ; ++k) { if (k > i) break; if (i + k == 2 * n + 9) return 99.0; }
  }
  return float(n);
}
void mainImage(out vec4 color, in vec2 p) {
  int z = int(p.x) & 1;
  bool ok = choose(-2 - z) == -1.0 && choose(3) == 33.0 && choose(1) == 1.0 && choose(8 + z) == float(8 + z) && choose(z) == float(z);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
