vec2 point(vec2 c) { return fract(vec2(c.x * 0.37 + c.y * 0.71, c.x * 0.53 + c.y * 0.29) * 3.7); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / 12.0, id = vec2(0.0);
  float best = 9.0, second = 9.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec2 c = floor(q) + vec2(x, y);
      vec2 r = c + point(c) - q;
      float d = dot(r, r);
      if (d < best) { second = best; best = d; id = c; } else if (d < second) second = d;
    }
  color = vec4(fract(id * 0.31), step(0.08, second - best), 1.0);
}
