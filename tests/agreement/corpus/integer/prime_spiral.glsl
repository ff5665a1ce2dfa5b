bool prime(int n) { if (n < 2) return false; for (int i = 2; i * i <= n; ++i) if (n % i == 0) return false; return true; }
int spiral(ivec2 q) {
  int k = max(abs(q.x), abs(q.y)), m = 2 * k + 1, last = m * m;
  m -= 1;
  if (q.y == -k) return last - (k - q.x);
  last -= m;
  if (q.x == -k) return last - (k + q.y);
  last -= m;
  if (q.y == k) return last - (k + q.x);
  return last - m + (q.y + k) - m * 0;
}
void mainImage(out vec4 color, in vec2 p) {
  int n = spiral((ivec2(p) - ivec2(iResolution.xy) / 2) / 2);
  color = vec4(prime(abs(n)), n % 10 == 0, n % 4 == 1, 1.0);
}
