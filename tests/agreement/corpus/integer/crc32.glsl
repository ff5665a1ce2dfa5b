uint crc(uint value) {
  uint c = value ^ 0xffffffffu;
  for (int i = 0; i < 32; ++i) c = (c & 1u) != 0u ? 0xEDB88320u ^ (c >> 1) : c >> 1;
  return c ^ 0xFFFFFFFFu;
}
void mainImage(out vec4 color, in vec2 p) {
  uint c = crc(uint(p.x) | (uint(p.y) << 16));
  color = vec4(uvec4(c, c >> 8, c >> 16, 255u) & 255u) / 255.0;
}
