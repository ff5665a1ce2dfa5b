// green = right. Of the amount of a shift the lower five bits count.
void mainImage(out vec4 o, vec2 p) {
  int zero = int(p.x) >> 20, one = zero + 1;
  uint unsigned_one = uint(one);
  bool ok = one << 32 == 1 && one << 33 == 2 && one << (zero + 33) == 2 && one << -1 == -2147483647 - 1 && -8 * one >> 33 == -4 &&
            -8 * one >> (zero + 32) == -8 && unsigned_one << 32 == 1u && 8u * unsigned_one >> 33 == 4u && 4000000000u * unsigned_one >> 32u == 4000000000u &&
            ivec2(one) << ivec2(33, 1) == ivec2(2);
  one <<= 35;
  ok = ok && one == 8;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}
