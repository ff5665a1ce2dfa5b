void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  for (int i = 0; i < 4; ++i) { q = abs(q) - 0.3; q = mat2(0.8, -0.6, 0.6, 0.8) * q; }
  color = vec4(step(0.0, q.x), step(0.1, q.y), step(0.2, abs(q.x - q.y)), 1.0);
}
