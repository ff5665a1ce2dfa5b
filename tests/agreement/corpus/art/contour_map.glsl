float height(vec2 q) { return dot(q, q) * 0.5 - q.x * q.y * 0.8 + 0.3 * q.x * q.x * q.y; }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float h = height(q) * 8.0;
  float line = abs(fract(h) - 0.5);
  color = vec4(mix(vec3(0.3, 0.6, 0.3), vec3(0.9, 0.9, 0.8), clamp(h * 0.1, 0.0, 1.0)) * (line > 0.42 ? 0.4 : 1.0), 1.0);
}
