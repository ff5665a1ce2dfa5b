void mainImage(out vec4 color, in vec2 p) {
  vec3 d = vec3((2.0 * p - iResolution.xy) / iResolution.y, 1.0);
  float t = -1.0 / min(d.y, -0.001);
  vec2 q = d.xz * t + vec2(0.0, iTime);
  float c = mod(floor(q.x) + floor(q.y), 2.0);
  color = d.y < 0.0 ? vec4(vec3(c) * exp(-0.1 * t), 1.0) : vec4(0.4, 0.6, 0.9, 1.0);
}
