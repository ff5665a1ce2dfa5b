// a + (b - a) * t does not end at b. REPAIRED: a * (1 - t) + b * t.
// options:
float blend(float a, float b, float t) {
#ifdef REPAIRED
  return a * (1.0 - t) + b * t;
#else
  return a + (b - a) * t;  // here: cancellation
#endif
}
void mainImage(out vec4 color, in vec2 position) {
  float b = 0.9 * position.x / iResolution.x;
  color = vec4(blend(30000000.0, b, 1.0));
}
