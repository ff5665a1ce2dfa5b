void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / iResolution.y;
  float f = 0.0;
  for (int i = 0; i < 5; ++i) {
    vec2 c = vec2(0.3 + 0.28 * float(i), 0.5 + 0.2 * float((i * 3) % 4 - 1));
    vec2 d = q - c;
    f += 0.012 / (dot(d, d) + 0.001);
  }
  color = vec4(step(0.6, f), step(1.0, f), min(f * 0.3, 1.0), 1.0);
}
