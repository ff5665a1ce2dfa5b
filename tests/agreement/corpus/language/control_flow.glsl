// green
int run(int n) {
  int s = 0;
  for (int i = 0, k = 10; i < n; ++i, --k) {
    if (i == 2) continue;
    if (k == 3) break;
    do { s += i; if (s > 15) return s; } while (false);
    switch (i) { case 1: s += 1; break; case 4: s -= 2; default: s += 0; }
  }
  return -s;
}
void mainImage(out vec4 color, in vec2 p) {
  int z = int(p.x) * 0;
  bool ok = run(3 + z) == -2 && run(5 + z) == -7 && run(20 + z) == 18;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
