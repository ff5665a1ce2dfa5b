// The hash that everybody copies. REPAIRED: integers (PCG).
// options:
float hash(vec2 p) {
#ifdef REPAIRED
  uint x = uint(p.x) * 1664525u + uint(p.y) * 22695477u + 1013904223u;
  x = ((x >> ((x >> 28u) + 4u)) ^ x) * 277803737u;
  return float((x >> 22u) ^ x) / 4294967296.0;
#else
  return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453);  // here: conditioning
#endif
}
void mainImage(out vec4 color, in vec2 position) {
  color = vec4(hash(position + 1000.0));
}
