// The length of a vector whose squares are too small. REPAIRED: it is scaled first.
// options:
void mainImage(out vec4 color, in vec2 position) {
  vec2 v = 1e-22 * position / iResolution.xy;
#ifdef REPAIRED
  float l = length(v * 1e22);
#else
  float l = length(v) * 1e22;  // here: underflow
#endif
  color = vec4(0.7 * l);
}
