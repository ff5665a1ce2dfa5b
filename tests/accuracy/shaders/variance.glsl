// E[x^2] - E[x]^2 of numbers far from 0. REPAIRED: from the mean.
// options:
float value(float i, vec2 p) { return 3000.0 + sin(i + p.x); }
void mainImage(out vec4 color, in vec2 position) {
  float sum = 0.0;
  float squares = 0.0;
  for (float i = 0.0; i < 16.0; i += 1.0) {
    sum += value(i, position);
    squares += value(i, position) * value(i, position);
  }
  float mean = sum / 16.0;
#ifdef REPAIRED
  float variance = 0.0;
  for (float i = 0.0; i < 16.0; i += 1.0) variance += pow(value(i, position) - mean, 2.0);
  variance /= 16.0;
#else
  float variance = squares / 16.0 - mean * mean;  // here: cancellation
#endif
  color = vec4(variance);
}
