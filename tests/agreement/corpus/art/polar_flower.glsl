void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float r = length(q), a = atan(q.y, q.x);
  float edge = 0.5 + 0.2 * cos(5.0 * a + iTime);
  color = vec4(mix(vec3(0.9, 0.3, 0.5), vec3(0.1, 0.1, 0.2), smoothstep(edge - 0.05, edge + 0.05, r)), 1.0);
}
