// green
// Words that GLSL got later, and names that look like somebody's own.
float buffer = 1.0, shared = 2.0;
float precise(float x) { return x + 1.0; }
float fma(float a, float b, float c) { return a - b - c; }
int bitCount(int x) { return -x; }
struct texture2DArray { float sampler1; };
void mainImage(out vec4 color, in vec2 p) {
  float packed = 3.0, dmat3 = 4.0, double_ = 5.0, vector = 6.0;
  texture2DArray t = texture2DArray(7.0);
  bool ok = buffer + shared + packed + dmat3 == 10.0 && precise(double_) == vector && fma(3.0, 1.0, 1.0) == 1.0 && bitCount(3) == -3 && t.sampler1 == 7.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
