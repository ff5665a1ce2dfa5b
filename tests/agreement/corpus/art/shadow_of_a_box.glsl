float box(vec3 o, vec3 d) {
  vec3 m = 1.0 / d, n = m * o, k = abs(m) * vec3(0.4, 0.4, 0.4);
  vec3 a = -n - k, b = -n + k;
  float near = max(max(a.x, a.y), a.z), far = min(min(b.x, b.y), b.z);
  return near > far || far < 0.0 ? -1.0 : near;
}
void mainImage(out vec4 color, in vec2 p) {
  vec3 o = vec3(0.3, 1.2, -2.7), d = vec3((2.0 * p - iResolution.xy) / iResolution.y, 2.0) + vec3(-0.2, -0.9, 0.013);
  float hit = box(o, d), floor_at = -(o.y + 0.4) / d.y;
  vec3 c = vec3(0.6, 0.75, 0.9);
  if (hit > 0.0) c = vec3(0.9, 0.5, 0.2);
  else if (floor_at > 0.0) c = vec3(box(o + floor_at * d + vec3(0.0, 0.001, 0.0), vec3(0.5, 0.8, -0.3)) > -0.5 ? 0.2 : 0.8);
  color = vec4(c, 1.0);
}
