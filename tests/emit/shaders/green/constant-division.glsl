// green = right. Divisions that a compiler does: by zero all bits are set, -2147483648 / -1 stays what it is.
const int zero = 0, least = -2147483647 - 1, minus = zero - 1, over = 7 / zero, rest = 7 % 0;
const uint none = 0u, all_over = 7u / none, all_rest = 7u % 0u;
const int overs[2] = int[2](zero / zero, least / -1);
const ivec2 both = ivec2(9, -9) / 0;
void mainImage(out vec4 o, vec2 p) {
  bool ok = over == -1 && rest == -1 && all_over == 0xffffffffu && all_rest == 0xffffffffu;
  ok = ok && overs[0] == -1 && overs[1] == least && least / minus == least && least % -1 == 0 && both == ivec2(-1);
  ok = ok && 8 / (3 - 3) + 1 == 0 && float(7 / 0) == -1. && -7 / -1 == 7 && 7 / -1 * 2 == -14 && 12 / 4 / (2 - 2) == -1;
  switch (int(p.x) >> 20) {
    case 1 / 0 + 1: break;
    default: ok = false;
  }
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}
