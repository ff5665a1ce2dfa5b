// The textbook quadratic of a sphere at 1,000 radii. REPAIRED: from the closest approach.
// options:
void mainImage(out vec4 color, in vec2 position) {
  vec3 origin = vec3(0.0, 0.0, 1000.0);
  vec2 uv = (position - 0.5 * iResolution.xy) / iResolution.y;
  vec3 d = normalize(vec3(uv * 0.0025, -1.0));
  float b = -dot(origin, d);
  float c = dot(origin, origin) - 1.0;
#ifdef REPAIRED
  vec3 closest = origin + b * d;
  float discriminant = 1.0 - dot(closest, closest);
#else
  float discriminant = b * b - c;  // here: cancellation
#endif
  color = vec4(sqrt(max(discriminant, 0.0)));
}
