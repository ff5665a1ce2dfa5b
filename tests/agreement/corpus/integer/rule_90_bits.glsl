void mainImage(out vec4 color, in vec2 p) {
  uint row = 0x00018000u;
  for (int i = 0; i < int(p.y) / 3; ++i) row = (row << 1) ^ (row >> 1);
  uint bit = (row >> (uint(p.x) / 4u & 31u)) & 1u;
  color = vec4(bit, float(row & 255u) / 255.0, float(row >> 24) / 255.0, 1.0);
}
