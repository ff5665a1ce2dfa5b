void mainImage(out vec4 f, in vec2 c) {
  float x = c.x / 128.0, y = c.y / 72.0, s = 0.0;
  s += step(0.1, x) * 0.1; s += step(0.2, x) * 0.1; s += step(0.3, x) * 0.1; s += step(0.4, x) * 0.1;
  s += step(0.5, x) * 0.1; s += step(0.6, x) * 0.1; s += step(0.7, x) * 0.1; s += step(0.8, x) * 0.1;
  s *= 1.0 - (step(0.25, y) * 0.25 + step(0.5, y) * 0.25 + step(0.75, y) * 0.25);
  f = vec4(s, s * 0.5, 1.0 - s, 1.0);
}
