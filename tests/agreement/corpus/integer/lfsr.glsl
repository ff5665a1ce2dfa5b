void mainImage(out vec4 color, in vec2 p) {
  uint state = 0xACE1u + uint(p.y) * 7u;
  int n = int(p.x) / 2;
  for (int i = 0; i < n; ++i) {
    uint bit = (state ^ (state >> 2) ^ (state >> 3) ^ (state >> 5)) & 1u;
    state = (state >> 1) | (bit << 15);
  }
  color = vec4(state & 1u, (state >> 7) & 1u, float(state & 255u) / 255.0, 1.0);
}
