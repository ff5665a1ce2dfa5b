// A path of straight pieces, as an exporter lists it.
float seg(vec2 p, float ax, float ay, float bx, float by) {
  vec2 a = vec2(ax, ay), d = vec2(bx, by) - a, r = p - a;
  float t = min(max((r.x * d.x + r.y * d.y) / (d.x * d.x + d.y * d.y), 0.0), 1.0);
  vec2 e = r - d * t;
  return e.x * e.x + e.y * e.y;
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / iResolution.xy * vec2(16.0, 9.0);
  float d = 1e9;
  d = min(d, seg(q, 1.0, 1.0, 4.0, 7.0)); d = min(d, seg(q, 4.0, 7.0, 7.0, 2.0));
  d = min(d, seg(q, 7.0, 2.0, 9.0, 6.0)); d = min(d, seg(q, 9.0, 6.0, 12.0, 6.5));
  d = min(d, seg(q, 12.0, 6.5, 11.0, 3.0)); d = min(d, seg(q, 11.0, 3.0, 15.0, 1.0));
  color = vec4(d < 0.04 ? vec3(0.05) : d < 0.3 ? vec3(0.9, 0.3, 0.3) : vec3(0.95, 0.93, 0.85), 1.0);
}
