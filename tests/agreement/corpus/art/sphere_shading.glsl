void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float h = 0.64 - dot(q, q);
  if (h < 0.0) { color = vec4(0.1, 0.12, 0.15, 1.0); return; }
  vec3 n = vec3(q, sqrt(h)) / 0.8;
  float l = max(dot(n, vec3(0.48, 0.6, 0.64)), 0.0);
  color = vec4(vec3(0.9, 0.4, 0.2) * l + 0.1, 1.0);
}
