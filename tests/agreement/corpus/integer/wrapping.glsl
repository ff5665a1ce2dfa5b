// green
void mainImage(out vec4 color, in vec2 p) {
  int z = int(p.y) * 0, big = 2147483647 - z;
  uint u = 4294967295u + uint(z);
  bool ok = big + 1 == -2147483647 - 1 && big * 2 == -2 && u + 2u == 1u && u * u == 1u && -(-5 + z) == 5;
  ok = ok && abs(-7 + z) == 7 && sign(-3 + z) == -1 && min(-1 + z, 1) == -1 && max(u, 1u) == u && clamp(9 + z, 0, 5) == 5;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
