// A loop that only discard ends. Not for browsers: they refuse it, or never come to its end.
void mainImage(out vec4 color, in vec2 p) {
  float sum = 1.0 / (1.0 + p.x);
  if (p.x + p.y > 20.0) { while (sum >= 0.0) { if (p.x > 1.0) discard; } }
  color = vec4(p, sum, 1.0);
}
