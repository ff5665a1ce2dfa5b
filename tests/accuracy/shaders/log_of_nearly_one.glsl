// log(1 + x) of a small x. REPAIRED: its series.
// options:
void mainImage(out vec4 color, in vec2 position) {
  float x = 0.00001 * (0.1 + position.x / iResolution.x);
#ifdef REPAIRED
  float y = x - 0.5 * x * x;
#else
  float y = log(1.0 + x);  // here: conditioning
#endif
  color = vec4(90000.0 * y);
}
