uint bcd(uint n) {
  uint r = 0u;
  for (int i = 15; i >= 0; --i) {
    for (int k = 0; k < 5; ++k) if (((r >> (4 * k)) & 15u) >= 5u) r += 3u << (4 * k);
    r = (r << 1) | ((n >> i) & 1u);
  }
  return r;
}
void mainImage(out vec4 color, in vec2 p) {
  uint b = bcd(uint(p.x) * 97u + uint(p.y) * 31u);
  color = vec4(b & 15u, (b >> 4) & 15u, (b >> 8) & 15u, 9) / 9.0;
}
