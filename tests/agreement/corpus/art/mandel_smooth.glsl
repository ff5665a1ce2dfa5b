void mainImage(out vec4 color, in vec2 p) {
  vec2 c = (p - vec2(0.7, 0.5) * iResolution.xy) / iResolution.y * 2.4, z = vec2(0.0);
  float n = 0.0;
  for (int i = 0; i < 40; ++i) {
    z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
    if (dot(z, z) > 64.0) break;
    n += 1.0;
  }
  float s = n < 40.0 ? n - log2(log2(dot(z, z))) + 2.0 : 40.0;
  color = vec4(0.5 + 0.5 * cos(0.3 * s + vec3(0.0, 0.6, 1.2)), 1.0);
}
