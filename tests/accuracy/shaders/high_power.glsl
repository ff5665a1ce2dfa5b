// A highlight with a very high exponent. REPAIRED: from how far the cosine is below 1.
// options:
void mainImage(out vec4 color, in vec2 position) {
  float below = 0.00002 * position.x / iResolution.x;
#ifdef REPAIRED
  float highlight = exp(-100000.0 * (below + 0.5 * below * below));
#else
  float highlight = pow(1.0 - below, 100000.0);  // here: coarse
#endif
  color = vec4(highlight);
}
