void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy, d = uv - 0.5;
  vec3 c = vec3(step(0.5, fract(uv * vec2(7.0, 4.0))), 0.5);
  c *= 1.0 - 1.6 * dot(d, d);
  c = (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
  float bar = step(0.1, uv.y) * step(uv.y, 0.9);
  color = vec4(c * bar, 1.0);
}
