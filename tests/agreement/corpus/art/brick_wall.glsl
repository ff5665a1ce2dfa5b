void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / vec2(20.0, 10.0);
  if (mod(floor(q.y), 2.0) > 0.5) q.x += 0.5;
  vec2 f = fract(q);
  vec2 edge = step(vec2(0.05, 0.1), f) * step(f, vec2(0.95, 0.9));
  float shade = 0.7 + 0.3 * fract(floor(q.x) * 0.37 + floor(q.y) * 0.61);
  color = vec4(mix(vec3(0.8), vec3(0.7, 0.3, 0.2) * shade, edge.x * edge.y), 1.0);
}
