// green
float f(float x) { return 1.0; }
float f(int x) { return 2.0; }
float f(uint x) { return 3.0; }
float f(vec2 x) { return 4.0; }
float f(float x, int y) { return 5.0; }
float f(float x[2]) { return 6.0; }
struct S { float a; };
float f(S s) { return 7.0; }
void mainImage(out vec4 color, in vec2 p) {
  bool ok = f(1.0) == 1.0 && f(1) == 2.0 && f(1u) == 3.0 && f(p) == 4.0 && f(1.0, 1) == 5.0 && f(float[2](1.0, 2.0)) == 6.0 && f(S(1.0)) == 7.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
