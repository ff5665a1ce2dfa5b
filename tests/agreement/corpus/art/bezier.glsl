void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / iResolution.xy, a = vec2(0.1, 0.2), b = vec2(0.5, 1.2), c = vec2(0.9, 0.3);
  float d = 9.0;
  for (int i = 0; i <= 32; ++i) {
    float t = float(i) / 32.0;
    vec2 e = a * (1.0 - t) * (1.0 - t) + b * 2.0 * t * (1.0 - t) + c * t * t - q;
    d = min(d, dot(e, e));
  }
  color = vec4(d < 0.0008 ? 1.0 : 0.0, d < 0.01 ? 0.5 : 0.1, 0.3, 1.0);
}
