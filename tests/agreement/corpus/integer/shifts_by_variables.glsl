// green
void mainImage(out vec4 color, in vec2 p) {
  int z = int(p.x) * 0;
  bool ok = true;
  for (int i = 0; i < 31; ++i) ok = ok && ((1 << (i + z)) >> i) == 1 && ((0x40000000 >> (i + z)) << i) <= 0x40000000;
  for (uint i = 0u; i < 32u; ++i) ok = ok && ((1u << i) >> i) == 1u && (0xffffffffu >> i) == (i == 0u ? ~0u : (1u << (32u - i)) - 1u);
  ok = ok && (ivec3(1, 2, 3) << (2 + z)) == ivec3(4, 8, 12) && (uvec2(16u) >> uvec2(1u, 3u)) == uvec2(8u, 2u);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}
