void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float d = 9.0;
  for (int i = 0; i < 64; ++i) {
    float t = float(i) / 64.0 * 6.2831853;
    d = min(d, distance(q, 0.8 * vec2(sin(3.0 * t + iTime), sin(2.0 * t))));
  }
  color = vec4(vec3(smoothstep(0.08, 0.04, d)), 1.0);
}
