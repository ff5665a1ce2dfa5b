// green
void mainImage(out vec4 color, in vec2 p) {
  int zero = int(iTime) * 0;
  bool ok = (-7 + zero) / 2 == -3 && (7 + zero) / -2 == -3 && int(-2.9 + float(zero)) == -2;
  ok = ok && ((-9 + zero) >> 1) == -5 && (uint(9 + zero) >> 1) == 4u && (~(5 + zero)) == -6;
  ok = ok && (3000000000u + uint(zero)) * 3u == 410065408u && uint(zero) - 1u == 4294967295u;
  ok = ok && ivec3(1, 2, 3) * ivec3(4, 5, 6 + zero) == ivec3(4, 10, 18) && (ivec2(7, 9 + zero) & ivec2(3, 5)) == ivec2(3, 1);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
