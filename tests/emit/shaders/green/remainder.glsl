// green = right. A remainder has the sign of the dividend; by zero it is -1, or all bits of a uint.
void mainImage(out vec4 o, vec2 p) {
  int zero = int(p.x) >> 20, a = zero - 7, b = a;
  int least = -2147483647 - 1 + zero;
  uint none = uint(zero);
  bool ok = a % 3 == -1 && (zero + 7) % -3 == 1 && a % -3 == -1 && a % (zero + 3) == -1 && a * 2 % 5 == -4 && -a % 4 == 3 &&
            10 - a % 4 * 2 == 16 && least % 3 == -2 && least % (zero - 1) == 0 && (zero + 5) % least == 5;
  b %= 4;
  ok = ok && b == -3;
  int list[3] = int[3](-7, -8, -9);
  int next = zero;
  list[next++] %= 5;
  ok = ok && list[0] == -2 && list[1] == -8 && next == 1 && (b %= 2) == -1;
  ivec3 v = ivec3(a, 8, -9) % 4, w = ivec3(a) % ivec3(2, 3, 4), u = a % ivec3(2, 3, zero);
  ok = ok && v == ivec3(-3, 0, -1) && w == ivec3(-1, -1, -3) && u == ivec3(-1, -1, -1);
  v.zx %= 2;
  ok = ok && v == ivec3(-1, 0, -1) && a % zero == -1 && (zero + 7) % zero == -1 && (7u + none) % none == 0xffffffffu;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}
