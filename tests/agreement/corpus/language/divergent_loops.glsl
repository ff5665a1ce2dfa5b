// green
void mainImage(out vec4 color, in vec2 p) {
  int x = int(p.x), sum = 0, rounds = 0;
  for (int i = 0; i < x % 7; ++i) {
    if ((i + x) % 3 == 0) continue;
    int k = i;
    while (k > 0) { sum += k & 1; k >>= 1; if (sum > 6) break; }
    ++rounds;
  }
  int expected = 0, turns = 0;
  int n = x - 7 * (x / 7);
  for (int i = 0; i < 7; ++i) {
    if (i >= n) break;
    if ((i + x) - 3 * ((i + x) / 3) == 0) continue;
    for (int k = i; k != 0; k /= 2) { expected += k - 2 * (k / 2); if (expected > 6) break; }
    turns += 1;
  }
  color = sum == expected && rounds == turns ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
