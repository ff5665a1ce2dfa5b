void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec3 c = mix(vec3(0.9, 0.95, 1.0), vec3(0.4, 0.6, 0.9), uv.y);
  for (int i = 0; i < 6; ++i) {
    float f = float(i);
    float h = 0.7 - 0.1 * f + 0.04 * sin(uv.x * (6.0 + 2.0 * f) + iTime * (1.0 + 0.2 * f) + f * 1.7);
    if (uv.y < h) c = mix(vec3(0.1, 0.4, 0.6), vec3(0.0, 0.1, 0.25), f / 5.0);
  }
  color = vec4(c, 1.0);
}
