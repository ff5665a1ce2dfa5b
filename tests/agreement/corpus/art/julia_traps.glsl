void mainImage(out vec4 color, in vec2 p) {
  vec2 z = (2.0 * p - iResolution.xy) / iResolution.y * 1.3;
  float trap = 9.0;
  int n = 0;
  for (; n < 24 && dot(z, z) < 16.0; ++n) {
    z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + vec2(-0.375, 0.625);
    trap = min(trap, abs(z.x));
  }
  color = vec4(float(n) / 24.0, min(trap * 2.0, 1.0), float(n & 1), 1.0);
}
