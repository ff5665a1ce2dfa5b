// green = right. By zero an int gives -1 and a uint all bits; -2147483648 / -1 stays what it is.
void mainImage(out vec4 o, vec2 p) {
  int zero = int(p.x) >> 20, a = zero - 7;
  int least = -2147483647 - 1 + zero;
  uint none = uint(zero);
  bool ok = a / zero == -1 && (zero + 7) / zero == -1 && zero / zero == -1 && (7u + none) / none == 0xffffffffu && a / 2 == -3 &&
            least / (zero - 1) == least && a / -1 == 7 && least / -1 == least && a * 2 / 3 == -4;
  int b = a;
  b /= zero;
  ivec2 v = ivec2(a, 9) / ivec2(zero, 2);
  v.y /= zero - 1;
  ok = ok && b == -1 && v == ivec2(-1, -4) && 12 / ivec2(zero, zero + 5) == ivec2(-1, 2);
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}
