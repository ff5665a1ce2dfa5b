#define ARGS float a, float b
#define PASS 1.0, 0.5
#define BOTH(x, y) (x + y)
#define FIRST(x, y) x
#define PAREN (2.0, 3.0)
float f(ARGS) { return a * b; }
void mainImage(out vec4 color, in vec2 p) {
  float x = f(PASS) + BOTH(FIRST(0.1, 9.0), max(0.1, 0.2)) + vec2 PAREN .y * 0.0;
  color = vec4(x * step(p.x, 60.0), x * 0.5, 0.2, 1.0);
}
