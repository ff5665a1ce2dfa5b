// The square of a short vector is below all floats; what divides by it only hears of that.
void mainImage(out vec4 color, in vec2 position) {
  vec2 d = 1e-23 * (position - 0.5 * iResolution.xy);
#ifdef REPAIRED
  d /= max(abs(d.x), abs(d.y));
  float square = dot(d, d);
#else
  float square = dot(d, d);  // here: underflow
#endif
  float scale = inversesqrt(square);
  color = vec4(0.5 + 0.5 * clamp(d * scale, -1.0, 1.0), 0.0, 1.0);
}
