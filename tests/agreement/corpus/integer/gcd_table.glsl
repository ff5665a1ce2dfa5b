int gcd(int a, int b) { while (b != 0) { int t = a % b; a = b; b = t; } return a; }
void mainImage(out vec4 color, in vec2 p) {
  int g = gcd(int(p.x) / 2 + 1, int(p.y) / 2 + 1);
  color = vec4(g == 1, g % 2 == 0, float(min(g, 12)) / 12.0, 1.0);
}
