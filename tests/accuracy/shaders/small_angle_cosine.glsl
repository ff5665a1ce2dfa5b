// 1 - cos(x) of a small angle. REPAIRED: 2 sin(x / 2)^2.
// options:
void mainImage(out vec4 color, in vec2 position) {
  float x = 0.001 + 0.0001 * position.x / iResolution.x;
#ifdef REPAIRED
  float s = sin(0.5 * x);
  float y = 2.0 * s * s;
#else
  float y = 1.0 - cos(x);  // here: cancellation
#endif
  color = vec4(y / (x * x));
}
