float smin(float a, float b, float k) { float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0); return mix(b, a, h) - k * h * (1.0 - h); }
float map(vec3 p) { return smin(length(p - vec3(0.4, 0.1, 0.0)) - 0.5, length(p + vec3(0.35, 0.0, 0.1)) - 0.4, 0.3); }
vec3 normal(vec3 p) {
  vec2 e = vec2(1.0, -1.0) * 0.01;
  return normalize(e.xyy * map(p + e.xyy) + e.yyx * map(p + e.yyx) + e.yxy * map(p + e.yxy) + e.xxx * map(p + e.xxx));
}
void mainImage(out vec4 color, in vec2 p) {
  vec3 o = vec3(0.0, 0.0, 2.5), d = normalize(vec3((2.0 * p - iResolution.xy) / iResolution.y, -2.0));
  float t = 0.0;
  int i = 0;
  for (; i < 48; ++i) { float h = map(o + t * d); if (h < 0.001 || t > 6.0) break; t += h; }
  color = t > 6.0 ? vec4(0.05, 0.05, 0.1, 1.0) : vec4(0.5 + 0.5 * normal(o + t * d), 1.0);
}
