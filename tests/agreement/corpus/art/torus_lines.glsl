float map(vec3 p) { vec2 q = vec2(length(p.xz) - 0.8, p.y); return length(q) - 0.3; }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  vec3 o = vec3(0.0, 1.6, 2.2), d = normalize(vec3(q.x, q.y * 0.8 - 1.4, -2.0));
  float t = 0.0;
  for (int i = 0; i < 60; ++i) t += map(o + t * d);
  vec3 h = o + t * d;
  color = t > 8.0 ? vec4(0.1, 0.1, 0.1, 1.0) : vec4(vec3(step(0.5, fract(atan(h.z, h.x) * 3.0))) * 0.8 + 0.1, 1.0);
}
