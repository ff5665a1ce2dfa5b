int gray(int n) { return n ^ (n >> 1); }
int degray(int g) { int n = 0; for (; g != 0; g >>= 1) n ^= g; return n; }
void mainImage(out vec4 color, in vec2 p) {
  int column = int(p.x) / 2;
  int row = int(p.y / iResolution.y * 8.0);
  float bit = float((gray(column) >> row) & 1);
  float back = degray(gray(column)) == column ? 1.0 : 0.0;
  color = vec4(bit, back, float((column >> row) & 1), 1.0);
}
