void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / 18.0;
  float best = 9.0, second = 9.0;
  int id = 0;
  for (int i = 0; i < 9; ++i) {
    vec2 c = floor(q) + vec2(i % 3 - 1, i / 3 - 1);
    int h = (int(c.x) * 37 + int(c.y) * 101 + 4096) & 63;
    vec2 d = c + vec2(h & 7, h >> 3) / 8.0 - q;
    float m = abs(d.x) + abs(d.y);
    if (m < best) { second = best; best = m; id = h; } else if (m < second) second = m;
  }
  color = vec4(vec3(id & 3, (id >> 2) & 3, id >> 4) / 3.0 * step(0.1, second - best), 1.0);
}
