// The angle between two directions that are nearly the same. REPAIRED: by the chord.
// options:
void mainImage(out vec4 color, in vec2 position) {
  vec3 a = normalize(vec3(1.0, 2.0, 3.0));
  vec3 b = normalize(vec3(1.0, 2.0, 3.0) + 0.002 * vec3(position / iResolution.xy, 0.0));
#ifdef REPAIRED
  float angle = 2.0 * asin(0.5 * length(a - b));
#else
  float angle = acos(dot(a, b));  // here: conditioning
#endif
  color = vec4(1500.0 * angle);
}
