// A loop that counts in steps of 0.1. REPAIRED: in integers.
// options:
void mainImage(out vec4 color, in vec2 position) {
  float sum = 0.0;
#ifdef REPAIRED
  for (int i = 0; i < 10; ++i) sum += 0.05;
#else
  float t = 0.0;
  while (t < 1.0) {  // here: branch
    t += 0.1;
    sum += 0.05;
  }
#endif
  color = vec4(sum * position.x / iResolution.x);
}
