// Built-ins whose constant arguments make Mesa compute them in another way.
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.yx;
  float x = sqrt(p.x / 7.0) - p.y / iResolution.x, y = p.y / iResolution.y;
  color = vec4(mix(x, y, 0.3), mix(x, 1.0, y), mix(vec2(x, y), uv, 0.7).y, mix(uv, vec2(y, x), x).x);
  if (p.y > 3.0) color = vec4(pow(y, 2.0), pow(y + x, 4.0), pow(2.0, x), pow(uv, vec2(2.0)).y);
  if (p.y > 6.0) color = vec4(min(0.0, -x * 0.0), max(vec2(0.5), uv).x, pow(y, 1.0), pow(abs(x), 1.3));
}
