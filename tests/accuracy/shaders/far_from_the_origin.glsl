// The direction between two points that lie far from the origin. REPAIRED: both are kept relative to a third.
// options:
void mainImage(out vec4 color, in vec2 position) {
  vec3 base = vec3(90000.0, 70000.0, 80000.0);
  vec3 offset = vec3(0.1 * (position / iResolution.xy - 0.5), 0.05);
#ifdef REPAIRED
  vec3 direction = normalize(offset);
#else
  vec3 p = base + offset;
  vec3 direction = normalize(p - base);  // here: cancellation
#endif
  color = vec4(0.5 + 0.5 * direction, 1.0);
}
