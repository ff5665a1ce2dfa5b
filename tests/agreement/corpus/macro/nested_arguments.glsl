// green
#define ADD(a, b) ((a) + (b))
#define MUL(a, b) ((a) * (b))
#define SQUARE(x) MUL(x, x)
#define APPLY(f, x) f(x)
#define CHAIN(x) ADD(SQUARE(x), ADD(MUL(2, x), 1))
#define CALL(f) f\
(3)
void mainImage(out vec4 color, in vec2 p) {
  int a = CHAIN(4);
  int b = APPLY(SQUARE, ADD(1, 2));
  int c = CALL(SQUARE);
  bool ok = a == 25 && b == 9 && c == 9;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
