// green
#define BAD(a, b) a * b
#define GOOD(a, b) ((a) * (b))
#define NEG -1
#define SUB(x) x - 1
void mainImage(out vec4 color, in vec2 p) {
  bool ok = BAD(1 + 2, 3 + 4) == 11 && GOOD(1 + 2, 3 + 4) == 21 && 2 NEG == 1 && 10 - SUB(4) == 5 && 2 * SUB(4) == 7;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
