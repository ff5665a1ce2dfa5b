vec4 over(vec4 a, vec4 b) { float k = a.a + b.a * (1.0 - a.a); return vec4((a.rgb * a.a + b.rgb * b.a * (1.0 - a.a)) / max(k, 1e-4), k); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec4 c = vec4(1.0, 1.0, 1.0, 1.0);
  c = over(vec4(1.0, 0.0, 0.0, 0.5 * step(uv.x, 0.6)), c);
  c = over(vec4(0.0, 1.0, 0.0, 0.4 * step(0.3, uv.x)), c);
  c = over(vec4(0.0, 0.0, 1.0, 0.6 * step(0.4, uv.y) * step(uv.y, 0.8)), c);
  color = c;
}
