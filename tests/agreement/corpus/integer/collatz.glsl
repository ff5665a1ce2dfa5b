int steps(int n) {
  int count = 0;
  while (n > 1 && count < 120) {
    n = (n & 1) == 0 ? n / 2 : 3 * n + 1;
    count++;
  }
  return count;
}
void mainImage(out vec4 color, in vec2 p) {
  int n = int(p.y) * 128 + int(p.x) + 1;
  int s = steps(n);
  color = vec4(float(s % 16) / 15.0, float(s / 16) / 7.0, n % 27 == 0, 1.0);
}
