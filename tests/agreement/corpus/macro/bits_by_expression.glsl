// green
#define BIT(n) (1 << (n))
#define MASK(hi, lo) ((BIT((hi) - (lo) + 1) - 1) << (lo))
#define FIELD(v, hi, lo) (((v) & MASK(hi, lo)) >> (lo))
#if (1 << 4 | 3) == 19 && (7 & ~2) == 5 && -7 / 2 == -3 && -7 % 2 == -1
#define ARITHMETIC true
#else
#define ARITHMETIC false
#endif
void mainImage(out vec4 color, in vec2 p) {
  int v = 0x5a3c;
  bool ok = FIELD(v, 7, 4) == 3 && FIELD(v, 15, 12) == 5 && MASK(5, 2) == 60 && ARITHMETIC;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
