void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float r2 = dot(q, q);
  vec3 d = vec3(0.0, 0.0, -1.0);
  if (r2 < 0.6) d = refract(d, vec3(q, sqrt(1.0 - r2)), 0.7);
  vec2 hit = q + d.xy / max(-d.z, 0.2);
  vec2 g = step(0.5, fract(hit * 4.0));
  color = vec4(abs(g.x - g.y), g, 1.0);
}
