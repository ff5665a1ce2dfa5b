vec3 hsv(vec3 c) { vec3 k = clamp(abs(mod(c.x * 6.0 + vec3(0, 4, 2), 6.0) - 3.0) - 1.0, 0.0, 1.0); return c.z * mix(vec3(1.0), k, c.y); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  color = vec4(hsv(vec3(atan(q.y, q.x) / 6.2831853 + 0.5, min(length(q), 1.0), 1.0)), 1.0);
}
